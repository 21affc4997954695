// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/curves.h"

#include "ui/docks/axis_choice.h"
#include "ui/docks/chart_view.h"
#include "ui/docks/pin_legend.h"
#include "ui/look/display.h"
#include "ui/runs/live_run.h"
#include "ui/runs/pinned_values.h"
#include "ui/runs/time_cursor.h"

#include <QComboBox>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace keyblock {

namespace {

constexpr int mostOfChoice = 320;  // [px]
constexpr int shortestWait = 300, longestWait = 5000;  // [ms] between two readings of a run in progress
constexpr int readingShare = 12;  // reading takes at most one part in this many of the time

/// Index of the last point that is not beyond `at`. \pre `x` increases and is not empty.
std::size_t indexAt(const std::vector<double>& x, double at) {
    const auto after = std::upper_bound(x.begin(), x.end(), at);
    return after == x.begin() ? 0 : static_cast<std::size_t>(after - x.begin()) - 1;
}

double valueAt(const std::vector<double>& x, const std::vector<double>& y, double at) {
    const std::size_t i = indexAt(x, at);
    if (i + 1 >= x.size() || x[i + 1] <= x[i]) return y[i];
    return y[i] + (y[i + 1] - y[i]) * std::clamp((at - x[i]) / (x[i + 1] - x[i]), 0.0, 1.0);
}

/// The last row or frame that is not later than `head`; none before the first.
template <typename Rows>
std::optional<std::size_t> placeOf(const Rows& rows, const FrameHead& head) {
    const auto places = std::views::iota(std::size_t{0}, rows.size());
    const auto timeOf = [&](std::size_t row) { return std::pair(rows[row].stage, rows[row].time); };
    const auto after = std::ranges::upper_bound(places, std::pair(head.stage, head.time), {}, timeOf);
    if (after == places.begin()) return std::nullopt;
    return static_cast<std::size_t>(after - places.begin()) - 1;
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
    connect(&timer_, &QTimer::timeout, this, [this] {
        if (isVisible()) read();
        else stale_ = true;  // read when it is visible again
    });
    connect(&cursor, &TimeCursor::runChanged, this, &Curves::runChanged);
    connect(&cursor, &TimeCursor::runGrew, this, &Curves::grow);
    connect(&cursor, &TimeCursor::moved, this, &Curves::showNow);
    connect(&display, &Display::changed, this, &Curves::choose);
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
        wanted_ = choice_->currentData().toString();
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
    read_.reset();
    choice_->clear();
    view_->clear(tr("History plots appear here once a run has started."));
    if (isVisible()) read();
}

void Curves::grow() {
    stale_ = true;
    if (isVisible() && !reads_ && !timer_.isActive()) timer_.start(shortestWait);
}

void Curves::setOther(std::shared_ptr<const LiveRun> other, const QString& name) {
    other_ = std::move(other);
    otherName_ = name;
    stale_ = true;
    if (other_ && isVisible()) read();
    if (!other_) choose();
}

/// Shows the newest pin.
void Curves::showPinned() {
    const auto& tracks = pins_->tracks();
    const bool more = tracks.size() > std::exchange(pinCount_, tracks.size());
    if (more) wanted_ = pinEntryName(tracks.back()->pin());
    stale_ = true;
    if (isVisible()) read();
}

void Curves::read() {
    if (!cursor_.run() || !stale_) return;
    stale_ = false;
    reads_ = true;
    CurveOrder order;
    order.run = std::make_shared<const RunSoFar>(cursor_.run());
    if (other_) order.other = std::make_shared<const RunSoFar>(other_);
    order.kind = kind_;
    if (pins_) order.tracks = pins_->tracks();
    if (choosesAxes()) order.y = axes_->y(), order.x = axes_->x();
    reader_.ask([this, order, run = cursor_.run(), asked = ++asked_]() -> Background::Result {
        QElapsedTimer clock;
        clock.start();
        auto reading = std::make_shared<const CurveReading>(readCurves(order));
        return [this, reading, run, asked, took = static_cast<int>(clock.elapsed())] {
            if (asked != asked_) return;
            reads_ = false;
            if (run == cursor_.run()) take(reading, took);
        };
    });
}

/// Readings take longer as rows are added, so the interval between them increases with their duration.
void Curves::take(std::shared_ptr<const CurveReading> reading, int took) {
    read_ = std::move(reading);
    fillChoice();
    choose();
    if (stale_ || cursor_.goesOn()) timer_.start(std::clamp(took * readingShare, shortestWait, longestWait));
}

void Curves::fillChoice() {
    QStringList names;
    for (const CurveEntry& entry : read_->own.entries) names += entry.name;
    if (axes_) names += tr("Any quantity against any other");
    QStringList offered;
    for (int i = 0; i < choice_->count(); ++i) offered += choice_->itemData(i).toString();
    if (names == offered) return;
    const QSignalBlocker quiet(choice_);
    choice_->clear();
    for (const QString& name : names) choice_->addItem(QString(), name);
}

/// Updates the captions to the units shown. The data of the entries stay the same, so the choice does not change.
void Curves::captionChoice() {
    for (int i = 0; i < choice_->count(); ++i)
        choice_->setItemText(i, QString::fromStdString(shownTitle(choice_->itemData(i).toString().toStdString(),
                                                                  display_.numbers())));
}

/// True if the choice is the last entry of the list, which offers any quantities for the axes.
bool Curves::choosesAxes() const {
    return axes_ && choice_->count() > 0 && choice_->currentIndex() + 1 == choice_->count();
}

const CurveEntry* Curves::current() const {
    if (!read_) return nullptr;
    if (choosesAxes()) return read_->free.entries.empty() ? nullptr : &read_->free.entries.front();
    const int index = choice_->currentIndex();
    const std::vector<CurveEntry>& own = read_->own.entries;
    return index >= 0 && static_cast<std::size_t>(index) < own.size() ? &own[index] : nullptr;
}

void Curves::choose() {
    if (!cursor_.run() || !read_) return;
    captionChoice();
    const int index = choice_->findData(wanted_);
    choice_->setCurrentIndex(index >= 0 ? index : choice_->count() > 0 ? 0 : -1);
    const bool byAxes = choosesAxes();
    if (byAxes && std::exchange(offered_, cursor_.run()) != cursor_.run()) axes_->offer(*cursor_.run());
    if (axes_) axes_->setVisible(byAxes && !axes_->y().empty());
    if (byAxes && (read_->y != axes_->y() || read_->x != axes_->x())) {
        stale_ = true;
        return read();
    }
    const CurveEntry* entry = current();
    const QString why = byAxes ? read_->free.problem : read_->own.problem;
    if (!entry) return view_->clear(why.isEmpty() ? tr("None of the recorded quantities has changed yet.") : why);
    Chart chart = withOther(*entry).chart;
    showAs(chart, display_.numbers());
    view_->show(std::move(chart));
    showNow();
}

CurveEntry Curves::withOther(CurveEntry entry) const {
    if (!other_) return entry;
    const std::vector<CurveEntry>& others = choosesAxes() ? read_->otherFree.entries : read_->other.entries;
    const auto found = std::find_if(others.begin(), others.end(),
                                    [&](const CurveEntry& other) { return other.name == entry.name; });
    if (found != others.end()) addOther(entry, *found, otherName_);
    return entry;
}

void Curves::showNow() {
    const CurveEntry* entry = current();
    if (!entry || !cursor_.hasMoment() || entry->x.empty()) return view_->setNow(std::nullopt);
    const FrameHead head = cursor_.head();
    if (entry->chart.overTime) {
        const double at = read_->time.at(head.stage, head.time);
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

/// Moves the time to the clicked position on the chart.
void Curves::jump(double x) {
    const CurveEntry* entry = current();
    if (!entry || !cursor_.run() || entry->x.empty()) return;
    cursor_.pause();
    if (entry->chart.overTime) {
        const std::vector<StageSpan>& stages = read_->time.stages();
        if (stages.empty()) return;
        const StageMoment moment = momentAt(stages, x);
        return cursor_.goTo(StageTime{moment.span->stage, moment.time});
    }
    x /= factorOf(entry->chart.xTitle, display_.numbers());
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < entry->x.size(); ++i)
        if (!(std::abs(entry->x[i] - x) >= std::abs(entry->x[nearest] - x)) && std::isfinite(entry->x[i])) nearest = i;
    const HistoryLog& rows = cursor_.run()->historyRows();
    const auto& frames = cursor_.run()->frames();
    if (entry->ofFrames && nearest < frames.size()) cursor_.goTo(nearest);
    if (!entry->ofFrames && nearest < rows.size()) cursor_.goTo(StageTime{rows[nearest].stage, rows[nearest].time});
}

}  // namespace keyblock
