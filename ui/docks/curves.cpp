// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/curves.h"

#include "ui/docks/axis_choice.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/pin_legend.h"
#include "ui/look/display.h"
#include "ui/picture/run_time.h"
#include "ui/runs/live_run.h"
#include "ui/runs/pins.h"
#include "ui/runs/time_cursor.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

constexpr int mostOfChoice = 320;  // [px]
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

/// The last row or frame that is not later; nothing before the first.
template <typename Row>
std::optional<std::size_t> placeOf(const std::vector<Row>& rows, const FrameHead& head) {
    const auto after = std::upper_bound(rows.begin(), rows.end(), head, [](const FrameHead& h, const Row& row) {
        return std::pair(h.stage, h.time) < std::pair(row.stage, row.time);
    });
    if (after == rows.begin()) return std::nullopt;
    return static_cast<std::size_t>(after - rows.begin()) - 1;
}

}  // namespace

Curves::Curves(const Themes& themes, const Display& display, TimeCursor& cursor, CurveKind kind, Pins* pins,
               QWidget* parent)
    : QWidget(parent), display_(display), cursor_(cursor), kind_(kind), pins_(pins), choice_(new QComboBox(this)),
      view_(new ChartView(themes, this)) {
    const bool all = kind == CurveKind::All;
    setObjectName(all ? "curves" : "energies");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(all ? tr("Curves") : tr("Energies"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, all ? 6 : 2, 6, 4);
    column->setSpacing(2);
    column->addWidget(makeChoices());
    if (pins_) column->addWidget(new PinLegend(themes, *pins_, this));
    column->addWidget(view_, 1);
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &Curves::read);
    connect(&cursor, &TimeCursor::runChanged, this, &Curves::runChanged);
    connect(&cursor, &TimeCursor::runGrew, this, &Curves::grow);
    connect(&cursor, &TimeCursor::moved, this, &Curves::showNow);
    connect(&display, &Display::changed, this, [this] {
        stale_ = true;
        if (isVisible()) read();
    });
    connect(view_, &ChartView::picked, this, &Curves::jump);
    if (pins_) {
        connect(pins_, &Pins::changed, this, &Curves::showPinned);
        connect(pins_, &Pins::grew, this, &Curves::grow);
    }
    runChanged();
}

QWidget* Curves::makeChoices() {
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    const bool all = kind_ == CurveKind::All;
    choice_->setObjectName(all ? "curveChoice" : "energyChoice");
    choice_->setAccessibleName(all ? tr("Curve shown") : tr("Energies shown"));
    choice_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    choice_->setMinimumWidth(60);
    choice_->setMaximumWidth(mostOfChoice);
    row->addWidget(choice_);
    connect(choice_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        wanted_ = choice_->currentText();
        choose();
    });
    if (all) {
        axes_ = new AxisChoice(line);
        axes_->hide();
        row->addWidget(axes_);
        connect(axes_, &AxisChoice::chosen, this, &Curves::choose);
    }
    row->addStretch(1);
    line->setVisible(all);
    return line;
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

void Curves::grow() {
    stale_ = true;
    if (isVisible() && !timer_.isActive()) timer_.start(shortestWait);
}

void Curves::setOther(std::shared_ptr<const LiveRun> other, const QString& name) {
    other_ = std::move(other);
    otherName_ = name;
    otherEntries_ = other_ ? curveEntries(*other_, kind_).entries : std::vector<CurveEntry>();
    choose();
}

/// What was pinned last is what a person wants to see.
void Curves::showPinned() {
    const auto& tracks = pins_->tracks();
    const bool more = tracks.size() > std::exchange(pinCount_, tracks.size());
    if (more) wanted_ = pinEntryName(tracks.back()->pin());
    stale_ = true;
    if (isVisible()) read();
}

/// Takes longer with every row, so it is done less often.
void Curves::read() {
    if (!cursor_.run() || !stale_) return;
    stale_ = false;
    QElapsedTimer clock;
    clock.start();
    CurveEntries own = curveEntries(*cursor_.run(), kind_);
    problem_ = own.problem;
    entries_ = std::move(own.entries);
    if (pins_ && !pins_->tracks().empty())
        for (CurveEntry& entry : pinEntries(*cursor_.run(), pins_->tracks())) entries_.push_back(std::move(entry));
    fillChoice();
    choose();
    const int wait = std::clamp(static_cast<int>(clock.elapsed()) * share, shortestWait, longestWait);
    if (cursor_.goesOn()) timer_.start(wait);
}

void Curves::fillChoice() {
    QStringList names;
    for (const CurveEntry& entry : entries_) names += entry.name;
    if (axes_) names += tr("Any quantity over any other");
    QStringList shown;
    for (int i = 0; i < choice_->count(); ++i) shown += choice_->itemText(i);
    if (names == shown) return;
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    choice_->addItems(names);
}

/// The last of the choices.
bool Curves::choosesAxes() const {
    return axes_ && choice_->count() > 0 && choice_->currentIndex() + 1 == choice_->count();
}

const CurveEntry* Curves::current() const {
    if (choosesAxes()) return free_.entries.empty() ? nullptr : &free_.entries.front();
    const int index = choice_->currentIndex();
    return index >= 0 && static_cast<std::size_t>(index) < entries_.size() ? &entries_[static_cast<std::size_t>(index)]
                                                                           : nullptr;
}

void Curves::choose() {
    if (!cursor_.run()) return;
    const int index = choice_->findText(wanted_);
    choice_->setCurrentIndex(index >= 0 ? index : choice_->count() > 0 ? 0 : -1);
    const bool byAxes = choosesAxes();
    if (byAxes && std::exchange(offered_, cursor_.run()) != cursor_.run()) axes_->offer(*cursor_.run());
    if (axes_) axes_->setVisible(byAxes && !axes_->y().empty());
    if (byAxes) free_ = curveOver(*cursor_.run(), axes_->y(), axes_->x());
    const CurveEntry* entry = current();
    const QString why = byAxes ? free_.problem : problem_;
    if (!entry) return view_->clear(why.isEmpty() ? tr("Nothing of the history changes yet.") : why);
    Chart chart = withOther(*entry).chart;
    showAs(chart, display_.numbers());
    view_->show(std::move(chart));
    showNow();
}

CurveEntry Curves::withOther(CurveEntry entry) const {
    if (!other_) return entry;
    const auto found = std::find_if(otherEntries_.begin(), otherEntries_.end(),
                                    [&](const CurveEntry& other) { return other.name == entry.name; });
    if (found != otherEntries_.end() && !choosesAxes()) addOther(entry, *found, otherName_);
    if (!choosesAxes()) return entry;
    const CurveEntries over = curveOver(*other_, axes_->y(), axes_->x());
    if (!over.entries.empty()) addOther(entry, over.entries.front(), otherName_);
    return entry;
}

void Curves::showNow() {
    const CurveEntry* entry = current();
    if (!entry || !cursor_.hasMoment() || entry->x.empty()) return view_->setNow(std::nullopt);
    const FrameHead head = cursor_.head();
    if (entry->chart.overTime) {
        const double at = RunTime(*cursor_.run()).at(head.stage, head.time);
        return view_->setNow(ChartNow{at, {factorOf(entry->chart.panels.front().title, display_.numbers()) *
                                           valueAt(entry->x, entry->y, at)}});
    }
    const auto place = entry->ofFrames ? placeOf(cursor_.run()->frames(), head)
                                       : placeOf(cursor_.run()->historyRows(), head);
    if (!place) return view_->setNow(std::nullopt);
    const std::size_t row = std::min(*place, entry->x.size() - 1);
    if (!std::isfinite(entry->x[row]) || !std::isfinite(entry->y[row])) return view_->setNow(std::nullopt);
    view_->setNow(ChartNow{factorOf(entry->chart.xTitle, display_.numbers()) * entry->x[row],
                           {factorOf(entry->chart.panels.front().title, display_.numbers()) * entry->y[row]}});
}

/// To the moment of a place on the chart.
void Curves::jump(double x) {
    const CurveEntry* entry = current();
    if (!entry || !cursor_.run() || entry->x.empty()) return;
    cursor_.pause();
    if (entry->chart.overTime) {
        const RunTime time(*cursor_.run());
        if (time.stages().empty()) return;
        const StageMoment moment = momentAt(time.stages(), x);
        return cursor_.goTo(StageTime{moment.span->stage, moment.time});
    }
    x /= factorOf(entry->chart.xTitle, display_.numbers());
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < entry->x.size(); ++i)
        if (!(std::abs(entry->x[i] - x) >= std::abs(entry->x[nearest] - x)) && std::isfinite(entry->x[i])) nearest = i;
    const auto& rows = cursor_.run()->historyRows();
    const auto& frames = cursor_.run()->frames();
    if (entry->ofFrames && nearest < frames.size()) cursor_.goTo(nearest);
    if (!entry->ofFrames && nearest < rows.size()) cursor_.goTo(StageTime{rows[nearest].stage, rows[nearest].time});
}

}  // namespace keyblock
