// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/study_results.h"

#include "ui/figure/sweep_charts.h"
#include "ui/look/display.h"
#include "ui/look/elided_label.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/study/case_table_model.h"
#include "ui/study/sweep_view.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QTableView>
#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace keyblock {

namespace {

constexpr int caseRowHeight = 24, widestCaseColumn = 180, leastNumberColumn = 76;  // [px]

QString percentOf(double share) { return Display::number(100.0 * share, 3); }

}  // namespace

StudyResults::StudyResults(SweepSession& session, const Themes& themes, QWidget* parent)
    : QWidget(parent), session_(session), themes_(themes), answer_(new QLabel(this)), detail_(new QLabel(this)),
      caseText_(new ElidedLabel(this)), kind_(addChoice("study.chart", tr("Chart"))),
      result_(addChoice("study.result", tr("Result"))), against_(addChoice("study.against", tr("Over"))),
      againstText_(new QLabel(tr("over"), this)), chart_(new SweepView(themes, this)), model_(new CaseTableModel(this)),
      sorted_(new QSortFilterProxyModel(this)), table_(new QTableView(this)),
      openCase_(new QPushButton(tr("Open scene"), this)), openRun_(new QPushButton(tr("Open run"), this)) {
    setObjectName("studyResults");
    answer_->setObjectName("study.answer");
    answer_->setProperty("role", "title");
    detail_->setObjectName("study.detail");
    detail_->setProperty("role", "detail");
    for (QLabel* label : {answer_, detail_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* split = new QSplitter(Qt::Vertical, this);
    split->setChildrenCollapsible(false);
    split->addWidget(makeCharts());
    split->addWidget(makeCases());
    split->setStretchFactor(0, 3);
    split->setStretchFactor(1, 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 10, 16, 10);
    column->setSpacing(4);
    column->addWidget(answer_);
    column->addWidget(detail_);
    column->addWidget(split, 1);
    connect(&session, &SweepSession::changed, this, &StudyResults::fill);
    connect(&session, &SweepSession::replaced, this, [this] {
        case_ = 0;
        fillChoices();
        fill();
    });
    fillChoices();
    fill();
}

QComboBox* StudyResults::addChoice(const char* name, const QString& title) {
    auto* box = new QComboBox(this);
    box->setObjectName(name);
    box->setAccessibleName(title);
    box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    box->setMinimumContentsLength(12);
    connect(box, qOverload<int>(&QComboBox::activated), this, &StudyResults::showChart);
    return box;
}

QWidget* StudyResults::makeCharts() {
    auto* side = new QWidget(this);
    for (const QString& kind : {tr("Distribution"), tr("Scatter"), tr("Influence"), tr("Convergence")})
        kind_->addItem(kind);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(kind_);
    row->addWidget(result_, 1);
    row->addWidget(againstText_);
    row->addWidget(against_, 1);
    row->addStretch(0);  // where the chart has no other choices
    kind_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 4, 0, 4);
    column->addLayout(row);
    column->addWidget(chart_, 1);
    connect(chart_, &SweepView::picked, this, &StudyResults::selectCase);
    connect(chart_, &SweepView::activated, this, &StudyResults::caseWanted);
    return side;
}

QWidget* StudyResults::makeCases() {
    auto* side = new QWidget(this);
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(CaseTableModel::sortRole);
    table_->setModel(sorted_);
    table_->setObjectName("study.cases");
    table_->setAccessibleName(tr("Cases"));
    table_->setSortingEnabled(true);
    table_->sortByColumn(0, Qt::AscendingOrder);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::SingleSelection);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setShowGrid(false);
    table_->setTabKeyNavigation(false);
    table_->setProperty("framed", true);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(caseRowHeight);
    table_->horizontalHeader()->setMaximumSectionSize(widestCaseColumn);
    table_->horizontalHeader()->setHighlightSections(false);
    for (QPushButton* button : {openCase_, openRun_}) button->setAccessibleName(button->text());
    openCase_->setObjectName("study.openCase");
    openRun_->setObjectName("study.openRun");
    auto* row = new QHBoxLayout;
    row->addWidget(caseText_, 1);
    row->addWidget(openRun_);
    row->addWidget(openCase_);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 4, 0, 0);
    column->addLayout(row);
    column->addWidget(table_, 1);
    const auto numberOf = [this](const QModelIndex& index) { return sorted_->mapToSource(index).row() + 1L; };
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this, numberOf](const QModelIndex& index) {
                if (index.isValid()) selectCase(numberOf(index));
            });
    connect(table_, &QTableView::activated, this,
            [this, numberOf](const QModelIndex& index) { Q_EMIT caseWanted(numberOf(index)); });
    connect(openCase_, &QPushButton::clicked, this, [this] { Q_EMIT caseWanted(case_); });
    connect(openRun_, &QPushButton::clicked, this, [this] { Q_EMIT runWanted(case_); });
    return side;
}

/// Whether a result is a measured quantity, and not only yes or no.
bool StudyResults::isMeasured(const SweepColumn& column) {
    return std::any_of(column.values.begin(), column.values.end(),
                       [](double value) { return std::isfinite(value) && value != 0.0 && value != 1.0; });
}

/// The columns that can be shown, results first. The first that is measured is chosen.
void StudyResults::fillChoices() {
    const auto sweep = session_.opened();
    for (QComboBox* box : {result_, against_}) box->clear();
    if (!sweep) return;
    for (const SweepColumn& column : sweep->results.columns) {
        if (isResult(column)) result_->addItem(qt(column.name));
        if (column.role != ColumnRole::Verdict) against_->addItem(qt(column.name));
    }
    for (const SweepColumn& column : sweep->results.columns)
        if (column.role == ColumnRole::Parameter || column.role == ColumnRole::Fault) result_->addItem(qt(column.name));
    choosesResult_ = true;
}

/// Chooses the first result that is measured, once a case has finished.
void StudyResults::chooseResult() {
    const auto sweep = session_.opened();
    if (!choosesResult_ || !sweep || session_.finished() == 0) return;
    choosesResult_ = false;
    for (const SweepColumn& column : sweep->results.columns)
        if (isResult(column) && isMeasured(column)) return result_->setCurrentText(qt(column.name));
}

const SweepColumn* StudyResults::chosen(const QComboBox& box) const {
    const auto sweep = session_.opened();
    return sweep ? findColumn(sweep->results, box.currentText().toStdString()) : nullptr;
}

void StudyResults::fill() {
    chooseResult();
    const bool isFirst = model_->rowCount() == 0;
    model_->show(session_.opened());
    if (isFirst && model_->rowCount() > 0) {
        table_->resizeColumnsToContents();
        table_->setColumnWidth(0, std::max(table_->columnWidth(0), leastNumberColumn));
    }
    showAnswer();
    showChart();
    showCase();
}

void StudyResults::setStale(bool isStale) {
    isStale_ = isStale;
    showAnswer();
}

void StudyResults::showAnswer() {
    const auto sweep = session_.opened();
    QStringList lines;
    QString answer;
    if (!sweep) {
        answer = session_.isReading() ? tr("Reading the results…") : tr("The study has not been run yet.");
    } else {
        const SweepResults& results = sweep->results;
        const FailureShare share = failureShare(results);
        if (results.criterion.empty())
            answer = tr("%1 of %2 cases finished").arg(session_.finished()).arg(session_.cases());
        else if (share.decided == 0) answer = tr("No case is decided by the criterion of failure yet.");
        else
            answer = tr("Probability of failure: %1 %, with a 95 % interval from %2 % to %3 %")
                         .arg(percentOf(share.probability), percentOf(share.interval.low),
                              percentOf(share.interval.high));
        if (!results.criterion.empty())
            lines << tr("%1 of %2 decided cases fail. A case fails if: %3")
                         .arg(share.fails)
                         .arg(share.decided)
                         .arg(qt(results.criterion));
        if (isStale_) lines << tr("The study or its scene has changed since these cases were planned.");
        const auto odd = std::ranges::count_if(
            results.cases, [](const auto& one) { return one && one->outcome != CaseOutcome::Done; });
        if (odd > 0) lines << tr("%1 finished cases have no results; the table gives the reason of each.").arg(odd);
    }
    answer_->setText(answer);
    detail_->setText(lines.join('\n'));
    detail_->setVisible(!lines.isEmpty());
}

void StudyResults::showChart() {
    const auto kind = static_cast<ChartKind>(kind_->currentIndex());
    result_->setVisible(kind != ChartKind::Convergence);
    againstText_->setVisible(kind == ChartKind::Scatter);
    against_->setVisible(kind == ChartKind::Scatter);
    const auto sweep = session_.opened();
    const SweepColumn *result = chosen(*result_), *against = chosen(*against_);
    SweepChart chart;
    QString message = sweep ? tr("No case has finished yet.") : QString();
    if (kind == ChartKind::Convergence && sweep) {
        ConvergenceChart made = convergenceChartOf("", sweep->results);
        if (sweep->results.criterion.empty())
            message = tr("Enter under Setup when a case fails to see its probability.");
        else if (!made.points.empty()) chart = std::move(made);
    } else if (kind == ChartKind::Distribution && result) {
        HistogramChart made = histogramOf("", *result);
        if (!made.sorted.empty()) chart = std::move(made);
        else if (session_.finished() > 0) message = tr("No finished case has a value.");
    } else if (kind == ChartKind::Scatter && result && against) {
        ScatterChart made = scatterOf("", sweep->results, {against, result});
        if (!made.dots.empty()) chart = std::move(made);
        else if (session_.finished() > 0) message = tr("No finished case has both values.");
    } else if (kind == ChartKind::Influence && result) {
        if (TornadoChart made = tornadoOf("", sweep->results, *result); !made.bars.empty() && isVaried(*result))
            chart = std::move(made);
        else if (session_.finished() > 0) message = tr("The values of the finished cases do not vary.");
    }
    chart_->show(std::move(chart), message);
}

void StudyResults::selectCase(long number) {
    if (number == case_ || number > model_->rowCount()) return;
    case_ = number;
    const QModelIndex at = sorted_->mapFromSource(model_->index(static_cast<int>(number - 1), 0));
    if (at.isValid() && table_->currentIndex().row() != at.row()) {
        const QSignalBlocker quiet(table_->selectionModel());
        table_->selectRow(at.row());
        table_->setCurrentIndex(at);
        table_->viewport()->update();
    }
    table_->scrollTo(at);
    showCase();
}

void StudyResults::showCase() {
    const auto sweep = session_.opened();
    const bool isOne = sweep && case_ >= 1 && case_ <= session_.cases();
    openCase_->setEnabled(isOne);
    std::error_code none;
    openRun_->setEnabled(isOne && std::filesystem::exists(caseFolder(sweep->sweep.folder, case_) / "run.kbrun", none));
    openRun_->setToolTip(openRun_->isEnabled() ? QString()
                                               : tr("The study keeps no frames of this case. Choose under Setup which "
                                                    "are kept, and run it again."));
    QString text = tr("Select a case, or click on a dot of a scatter chart, to open its scene.");
    if (isOne) {
        const auto& one = sweep->results.cases[static_cast<std::size_t>(case_ - 1)];
        text = tr("Case %1").arg(case_);
        if (!one) text += tr(": not run yet");
        else if (!one->reason.empty()) text += ": " + qt(one->reason);
        else if (one->fails) text += *one->fails ? tr(": fails") : tr(": does not fail");
    }
    caseText_->setText(text);
    chart_->setCase(isOne ? case_ : 0);
}

}  // namespace keyblock
