// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/time_track.h"

#include "solver/results/result_names.h"
#include "ui/docks/event_marks.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/picture/captions.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double narrowest = 1e-4;  // fraction of the axis
constexpr double leastBetweenMarks = 12.0, grabs = 7.0;  // [px]

/// Counts each event at the mark nearest to it. \param placed marks in order; not empty if there are events
void countEvents(const std::vector<PlacedEvent>& all, std::vector<PlacedEvent>& placed) {
    for (PlacedEvent& mark : placed) mark.count = 0;
    for (const PlacedEvent& event : all) {
        auto nearest = std::lower_bound(placed.begin(), placed.end(), event.x,
                                        [](const PlacedEvent& mark, double x) { return mark.x < x; });
        const bool isLeft = nearest == placed.end() ||
                            (nearest != placed.begin() && event.x - std::prev(nearest)->x < nearest->x - event.x);
        ++(isLeft ? std::prev(nearest) : nearest)->count;
    }
}

}  // namespace

std::vector<PlacedEvent> placedEvents(const std::vector<Event>& events, const std::vector<double>& places,
                                      double least) {
    std::vector<PlacedEvent> all;
    for (std::size_t i = 0; i < events.size(); ++i)
        if (std::isfinite(places[i])) all.push_back({rowOf(events[i].kind).group, places[i], i});
    const auto severityOf = [&](const PlacedEvent& mark) { return rowOf(events[mark.event].kind).severity; };
    std::stable_sort(all.begin(), all.end(), [&](const PlacedEvent& a, const PlacedEvent& b) {
        return severityOf(a) > severityOf(b);
    });
    std::vector<double> taken;  // in increasing order
    std::vector<PlacedEvent> placed;
    for (const PlacedEvent& mark : all) {
        const auto next = std::lower_bound(taken.begin(), taken.end(), mark.x);
        if (next != taken.end() && *next - mark.x < least) continue;
        if (next != taken.begin() && mark.x - *(next - 1) < least) continue;
        taken.insert(next, mark.x);
        placed.push_back(mark);
    }
    std::sort(placed.begin(), placed.end(), [](const PlacedEvent& a, const PlacedEvent& b) { return a.x < b.x; });
    countEvents(all, placed);
    return placed;
}

TimeTrack::TimeTrack(const Themes& themes, TimeCursor& cursor, QWidget* parent)
    : QWidget(parent), themes_(themes), cursor_(cursor) {
    setObjectName("timeTrack");
    setAccessibleName(tr("Timeline"));
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setFixedHeight(76);
    const auto repaint = [this] { update(); };
    connect(&themes, &Themes::changed, this, repaint);
    connect(&cursor, &TimeCursor::runChanged, this, &TimeTrack::takeRun);
    connect(&cursor, &TimeCursor::runGrew, this, repaint);
    connect(&cursor, &TimeCursor::moved, this, repaint);
    connect(&cursor, &TimeCursor::changed, this, [this] {
        laid_.valid = false;
        update();
    });
    takeRun();
}

void TimeTrack::takeRun() {
    axis_ = cursor_.run() ? TimeAxis(cursor_.run()->scene()) : TimeAxis();
    low_ = 0.0;
    high_ = 1.0;
    laid_.valid = false;
    update();
}

double TimeTrack::xOf(double place) const {
    return inset + (width() - 2.0 * inset) * (place - low_) / (high_ - low_);
}

double TimeTrack::placeAt(double x) const {
    return low_ + (high_ - low_) * (x - inset) / std::max(1.0, width() - 2.0 * inset);
}

void TimeTrack::setWindow(double low, double high) {
    const double span = std::clamp(high - low, narrowest, 1.0);
    low_ = std::clamp(low, 0.0, 1.0 - span);
    high_ = low_ + span;
    update();
}

void TimeTrack::zoomOut() { setWindow(0.0, 1.0); }

const std::vector<PlacedEvent>& TimeTrack::marks() const {
    const std::vector<Event>& events = cursor_.run()->eventList();
    const Laid wanted{events.size(), low_, high_, width(), true};
    if (laid_.valid && laid_.events == wanted.events && laid_.low == low_ && laid_.high == high_ &&
        laid_.width == wanted.width)
        return marks_;
    laid_ = wanted;
    std::vector<double> places;
    columns_.clear();
    for (const Event& event : events) {
        const double x = xOf(axis_.at(event.stage, event.time));
        const bool shown = !cursor_.hiddenKinds().contains(event.kind) && x >= inset - 1.0 && x <= width() - inset + 1.0;
        places.push_back(shown ? x : std::nan(""));
        if (shown) columns_.push_back(static_cast<int>(std::lround(x)));
    }
    std::sort(columns_.begin(), columns_.end());
    columns_.erase(std::unique(columns_.begin(), columns_.end()), columns_.end());
    marks_ = placedEvents(events, places, leastBetweenMarks);
    return marks_;
}

bool TimeTrack::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QString tip = tipAt(help->pos());
    if (tip.isEmpty()) QToolTip::hideText();
    else QToolTip::showText(help->globalPos(), asTip(tip), this);
    return true;
}

/// The event at the pointer; if there is none, the time.
QString TimeTrack::tipAt(const QPointF& at) const {
    if (axis_.isEmpty()) return {};
    const LiveRun& run = *cursor_.run();
    for (const PlacedEvent& mark : marks()) {
        if (std::abs(mark.x - at.x()) > grabs || at.y() < 36.0) continue;
        const Event& event = run.eventList()[mark.event];
        QString text = nameOf(event.kind);
        const std::string subject = event.bolt >= 0 ? boltName(run.scene(), event.bolt)
                                                    : blockName(run.blockNames(), event.block);
        if (!subject.empty()) text += QStringLiteral(" · ") + QString::fromStdString(subject);
        if (mark.count > 1) text += QStringLiteral(" · ") + tr("%1 events here; scroll to zoom in").arg(mark.count);
        return text + QStringLiteral(" · ") +
               QString::fromStdString(timeText(run.scene(), event.stage, event.time));
    }
    const TimeAxis::Moment moment = axis_.momentAt(std::clamp(placeAt(at.x()), 0.0, 1.0));
    return QString::fromStdString(stageName(run.scene(), moment.stage) + " · " +
                                  timeText(run.scene(), moment.stage, moment.time));
}

void TimeTrack::scrubTo(double x) {
    if (axis_.isEmpty()) return;
    const TimeAxis::Moment moment = axis_.momentAt(std::clamp(placeAt(x), 0.0, 1.0));
    cursor_.pause();
    cursor_.goTo(StageTime{moment.stage, moment.time});
}

void TimeTrack::mousePressEvent(QMouseEvent* event) {
    if (axis_.isEmpty()) return;
    dragFrom_ = event->localPos();
    dragLow_ = low_;
    const auto b = cursor_.cursorB();
    const auto xOfFrame = [&](std::size_t frame) {
        const FrameHead& head = cursor_.run()->frames()[frame];
        return xOf(axis_.at(head.stage, head.time));
    };
    if (event->button() == Qt::MiddleButton) {
        drag_ = Drag::Pan;
    } else if (event->button() == Qt::LeftButton) {
        const bool onB = b && dragFrom_.y() < 14.0 && std::abs(xOfFrame(*b) - dragFrom_.x()) < grabs;
        drag_ = onB ? Drag::CursorB : Drag::Time;
        if (event->modifiers() & Qt::ControlModifier) drag_ = Drag::CursorB;
        mouseMoveEvent(event);
    }
}

void TimeTrack::mouseMoveEvent(QMouseEvent* event) {
    if (axis_.isEmpty()) return;
    const double x = event->localPos().x();
    if (drag_ == Drag::Time) scrubTo(x);
    if (drag_ == Drag::Pan) {
        const double by = (dragFrom_.x() - x) * (high_ - low_) / std::max(1.0, width() - 2.0 * inset);
        setWindow(dragLow_ + by, dragLow_ + by + (high_ - low_));
    }
    if (drag_ != Drag::CursorB || cursor_.run()->frames().empty()) return;
    // The frame nearest to the mouse pointer.
    const auto& frames = cursor_.run()->frames();
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < frames.size(); ++i)
        if (std::abs(xOf(axis_.at(frames[i].stage, frames[i].time)) - x) <
            std::abs(xOf(axis_.at(frames[nearest].stage, frames[nearest].time)) - x))
            nearest = i;
    if (cursor_.cursorB() != nearest) cursor_.setCursorB(nearest);
}

void TimeTrack::mouseReleaseEvent(QMouseEvent*) { drag_ = Drag::Nothing; }

void TimeTrack::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) zoomOut();
    else mousePressEvent(event);
}

void TimeTrack::wheelEvent(QWheelEvent* event) {
    if (axis_.isEmpty()) return;
    const QPoint turned = event->angleDelta();
    const double span = high_ - low_;
    if (turned.x() != 0 || event->modifiers() & Qt::ShiftModifier) {
        const double by = -(turned.x() != 0 ? turned.x() : turned.y()) / 1200.0 * span;
        setWindow(low_ + by, high_ + by);
    } else {
        const double at = std::clamp(placeAt(event->position().x()), 0.0, 1.0);
        const double wide = std::clamp(span * std::pow(1.0015, -turned.y()), narrowest, 1.0);
        const double share = (at - low_) / span;
        setWindow(at - share * wide, at - share * wide + wide);
    }
    event->accept();
}

void TimeTrack::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Left) cursor_.step(-1);
    else if (event->key() == Qt::Key_Right) cursor_.step(1);
    else QWidget::keyPressEvent(event);
}

}  // namespace keyblock
