// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/quantity_table.h"

#include "solver/results/run_source.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <string>

namespace keyblock {

namespace {

constexpr std::size_t mostInOrder = 6, mostInToolTip = 60;  // events of `order KIND` that are listed

enum Column { Name, Measured, Expect, Deviation, Tolerance, Verdict, Source };

QString numberOf(const Measurement& measurement) {
    return measurement.value ? Display::number(*measurement.value, 5) : QStringLiteral("–");
}

/// A deviation or tolerance in percent of the expected value; as a number if the expected value is 0.
QString shareText(double value, bool isRelative) {
    return isRelative ? Display::number(100.0 * value, 2) + QStringLiteral(" %") : Display::number(value, 3);
}

/// True if no stage was interrupted; only then can expected values be checked.
bool isWholeRun(const std::vector<StageRecord>& stages) {
    return std::ranges::all_of(stages, [](const StageRecord& stage) {
        return stage.ended && (endedAsPlanned(stage.result.outcome) || endedUnstable(stage.result.outcome));
    });
}

}  // namespace

struct QuantityTable::Reading {
    std::vector<MeasuredComparison> expected;
    std::vector<std::pair<std::string, Measurement>> asked;
    bool isWhole = false;
};

QuantityTable::QuantityTable(const Themes& themes, const TimeCursor& cursor, QWidget* parent)
    : QWidget(parent), themes_(themes), cursor_(cursor), hint_(new QLabel(this)), list_(new QTreeWidget(this)) {
    setObjectName("quantityTable");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Quantities"));
    hint_->setAlignment(Qt::AlignCenter);
    hint_->setWordWrap(true);
    hint_->setContentsMargins(16, 8, 16, 8);
    hint_->setProperty("role", "hint");
    list_->setObjectName("quantities");
    list_->setAccessibleName(tr("Computed and expected values"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setHeaderLabels({tr("Quantity"), tr("Computed, SI"), tr("Expected, SI"), tr("Deviation"), tr("Tolerance"),
                            tr("Verdict"), tr("Source")});
    for (const int column : {Measured, Expect, Deviation, Tolerance})
        list_->headerItem()->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(hint_, 1);
    column->addWidget(list_, 1);
    for (const auto signal : {&TimeCursor::runChanged, &TimeCursor::runGrew, &TimeCursor::changed})
        connect(&cursor, signal, this, &QuantityTable::read);
    connect(&themes, &Themes::changed, this, [this] {
        rows_ = 0;
        read();
    });
    fill({});
}

QuantityTable::~QuantityTable() = default;

void QuantityTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    read();
}

/// Reads only finished runs, because most quantities are not available before the end.
void QuantityTable::read() {
    if (!isVisible()) return;
    const auto run = cursor_.run();
    if (!run) return fill({});
    const std::size_t rows = run->historyRows().size() + 1;
    if (cursor_.goesOn() || (run == run_ && rows == rows_)) return;
    run_ = run;
    rows_ = rows;
    reader_.ask([this, run, soFar = std::make_shared<const RunSoFar>(run)]() -> Background::Result {
        Reading reading;
        const std::vector<HistoryRow> history = soFar->history();
        const std::vector<Event> events = soFar->events();
        const Scene& scene = soFar->scene();
        const std::vector<StageRecord> stages = soFar->stages();
        const RecordedRun recorded{scene, history, events, stages};
        for (const Expected& expected : scene.about.expected) reading.expected.push_back(compare(expected, recorded));
        for (const std::string& text : scene.quantities) reading.asked.emplace_back(text, measure(text, recorded));
        reading.isWhole = isWholeRun(stages);
        return [this, run, reading = std::move(reading)] {
            if (run == cursor_.run()) fill(reading);
        };
    });
}

void QuantityTable::fill(const Reading& reading) {
    list_->clear();
    for (const MeasuredComparison& comparison : reading.expected) addExpected(comparison, reading.isWhole);
    for (const auto& [text, measurement] : reading.asked) {
        auto* row = new QTreeWidgetItem(list_, {QString::fromStdString(text), numberOf(measurement)});
        row->setTextAlignment(Measured, Qt::AlignRight | Qt::AlignVCenter);
        row->setText(Source, QString::fromStdString(measurement.problem));
        if (measurement.order.empty()) continue;
        row->setText(Source, QString::fromStdString(orderText(measurement.order, mostInOrder)));
        row->setToolTip(Source, QString::fromStdString(orderText(measurement.order, mostInToolTip)));
    }
    const bool isEmpty = list_->topLevelItemCount() == 0;
    list_->setVisible(!isEmpty);
    hint_->setVisible(isEmpty);
    hint_->setText(!cursor_.run()        ? tr("Run the scene to see the quantities it defines.")
                   : cursor_.goesOn() ? tr("Quantities are evaluated at the end of the run.")
                                      : tr("This scene defines no quantities and no expected values."));
    for (int column = Name; column < Source; ++column) list_->resizeColumnToContents(column);
}

void QuantityTable::addExpected(const MeasuredComparison& comparison, bool isWhole) {
    const Expected& expected = comparison.expected;
    const bool isKnown = comparison.measured.value.has_value(), isRelative = expected.value != 0.0;
    const QString verdict = !isWhole ? tr("run not finished") : comparison.within ? tr("met") : tr("not met");
    auto* row = new QTreeWidgetItem(
        list_, {QString::fromStdString(expected.quantity), numberOf(comparison.measured), Display::number(expected.value, 5),
                isKnown ? shareText(comparison.deviation, isRelative) : QString(), shareText(expected.tolerance, isRelative),
                verdict, QString::fromStdString(isKnown ? expected.source : comparison.measured.problem)});
    for (const int column : {Measured, Expect, Deviation, Tolerance})
        row->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
    row->setToolTip(Source, asTip(row->text(Source)));
    if (isWhole) row->setForeground(Verdict, comparison.within ? themes_.current().ok : themes_.current().error);
}

}  // namespace keyblock
