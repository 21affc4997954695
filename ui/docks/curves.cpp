// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/curves.h"

#include "ui/docks/chart_view.h"
#include "ui/picture/history_charts.h"
#include "ui/picture/run_time.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int shortestWait = 300, longestWait = 5000;  // [ms] between two readings of a run that grows
constexpr int share = 12;  // of the time, one in so many, is spent on reading

/// Index of the point at `x`, or the last before it. \pre rising, not empty.
std::size_t indexAt(const std::vector<double>& x, double at) {
    const auto after = std::upper_bound(x.begin(), x.end(), at);
    return after == x.begin() ? 0 : static_cast<std::size_t>(after - x.begin()) - 1;
}

double valueAt(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const std::size_t i = indexAt(x, at);
    if (i + 1 >= x.size() || x[i + 1] <= x[i]) return y[i];
    return y[i] + (y[i + 1] - y[i]) * std::clamp((at - x[i]) / (x[i + 1] - x[i]), 0.0, 1.0);
}

}  // namespace

Curves::Curves(const Themes& themes, TimeCursor& cursor, CurveKind kind, QWidget* parent)
    : QWidget(parent), cursor_(cursor), kind_(kind), choice_(new QComboBox(this)), view_(new ChartView(themes, this)) {
    const bool all = kind == CurveKind::All;
    setObjectName(all ? "curves" : "energies");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(all ? tr("Curves") : tr("Energies"));
    choice_->setObjectName(all ? "curveChoice" : "energyChoice");
    choice_->setAccessibleName(all ? tr("Curve shown") : tr("Energies shown"));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    choice_->setVisible(all);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, all ? 6 : 2, 6, 4);
    column->setSpacing(2);
    column->addWidget(choice_, 0, Qt::AlignLeft);
    column->addWidget(view_, 1);
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Curves::read);
    connect(&cursor, &TimeCursor::runChanged, this, &Curves::runChanged);
    connect(&cursor, &TimeCursor::runGrew, this, [this] {
        stale_ = true;
        if (isVisible() && !timer_.isActive()) timer_.start(shortestWait);
    });
    connect(&cursor, &TimeCursor::moved, this, &Curves::showNow);
    connect(view_, &ChartView::picked, this, &Curves::jump);
    connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        wanted_ = choice_->currentText();
        choose();
    });
    runChanged();
}

void Curves::showEvent(QShowEvent*) {
    if (stale_) read();
}

void Curves::runChanged() {
    stale_ = true;
    entries_.clear();
    choice_->clear();
    view_->clear(tr("Curves of the history stand here once there is a run."));
    if (isVisible()) read();
}

/// Takes longer with every row, so it is done less often.
void Curves::read() {
    if (!cursor_.run() || !stale_) return;
    stale_ = false;
    QElapsedTimer clock;
    clock.start();
    const HistoryCharts charts = historyCharts(*cursor_.run(), std::nullopt);
    problem_ = QString::fromStdString(charts.problem);
    entries_.clear();
    for (const Chart& chart : charts.charts)
        for (const ChartPanel& panel : chart.panels) {
            if (panel.curves.empty() || (kind_ == CurveKind::Energies) != panel.title.starts_with("Energy")) continue;
            Entry entry{QString::fromStdString(panel.title), chart, panel.curves.front().x, panel.curves.front().y};
            if (!chart.overTime) entry.name = tr("%1 over %2").arg(entry.name, QString::fromStdString(chart.xTitle));
            entry.chart.panels = {panel};
            entries_.push_back(std::move(entry));
        }
    QStringList names;
    for (const Entry& entry : entries_) names += entry.name;
    QStringList shown;
    for (int i = 0; i < choice_->count(); ++i) shown += choice_->itemText(i);
    if (names != shown) {
        const QSignalBlocker quiet(choice_);
        choice_->clear();
        choice_->addItems(names);
    }
    choose();
    const int wait = std::clamp(static_cast<int>(clock.elapsed()) * share, shortestWait, longestWait);
    if (cursor_.goesOn()) timer_.start(wait);
}

const Curves::Entry* Curves::current() const {
    const int index = choice_->currentIndex();
    return index >= 0 && static_cast<std::size_t>(index) < entries_.size() ? &entries_[static_cast<std::size_t>(index)]
                                                                           : nullptr;
}

void Curves::choose() {
    const int index = choice_->findText(wanted_);
    choice_->setCurrentIndex(index >= 0 ? index : entries_.empty() ? -1 : 0);
    const Entry* entry = current();
    if (!entry) return view_->clear(problem_.isEmpty() ? tr("Nothing of the history changes yet.") : problem_);
    view_->show(entry->chart);
    showNow();
}

void Curves::showNow() {
    const Entry* entry = current();
    if (!entry || !cursor_.hasMoment() || entry->x.empty()) return view_->setNow(std::nullopt);
    const FrameHead head = cursor_.head();
    if (entry->chart.overTime) {
        const double at = RunTime(*cursor_.run()).at(head.stage, head.time);
        return view_->setNow(ChartNow{at, {valueAt(entry->x, entry->y, at)}});
    }
    const auto& rows = cursor_.run()->historyRows();
    const auto after = std::upper_bound(rows.begin(), rows.end(), head, [](const FrameHead& h, const HistoryRow& row) {
        return std::pair(h.stage, h.time) < std::pair(row.stage, row.time);
    });
    if (after == rows.begin()) return view_->setNow(std::nullopt);
    const auto row = std::min(static_cast<std::size_t>(after - rows.begin()), entry->x.size()) - 1;
    view_->setNow(ChartNow{entry->x[row], {entry->y[row]}});
}

/// To the moment of a place on the chart.
void Curves::jump(double x) {
    const Entry* entry = current();
    if (!entry || !cursor_.run() || entry->x.empty()) return;
    cursor_.pause();
    if (entry->chart.overTime) {
        const RunTime time(*cursor_.run());
        for (const StageSpan& span : time.stages())
            if (x <= span.to || span.stage == time.stages().back().stage)
                return cursor_.goTo(StageTime{span.stage, std::max(0.0, x - span.from)});
        return;
    }
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < entry->x.size(); ++i)
        if (std::abs(entry->x[i] - x) < std::abs(entry->x[nearest] - x)) nearest = i;
    const auto& rows = cursor_.run()->historyRows();
    if (nearest < rows.size()) cursor_.goTo(StageTime{rows[nearest].stage, rows[nearest].time});
}

}  // namespace keyblock
