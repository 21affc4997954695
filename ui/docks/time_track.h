// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stages of a run side by side with their progress, the events below them, and the
// two cursors. Clicking and dragging moves through time; the wheel zooms.
#pragma once

#include "solver/results/results.h"
#include "ui/picture/ticks.h"
#include "ui/runs/time_axis.h"

#include <QWidget>

#include <optional>
#include <vector>

namespace keyblock {

class Themes;
class TimeCursor;

/// A mark on the timeline: the event that it shows, and the number of events that it represents.
struct PlacedEvent {
    EventGroup group = EventGroup::Slip;
    double x = 0.0;  // [px]
    std::size_t event = 0;
    int count = 1;  // events represented by this mark, including those without room for their own
};

/// Places the marks of events, the most severe events first. A mark that would be less than `least` [px] from a mark
/// already placed is omitted. The result is in increasing order of position.
/// \param places positions on the timeline [px], one per event; NaN: the event is not shown
std::vector<PlacedEvent> placedEvents(const std::vector<Event>& events, const std::vector<double>& places,
                                      double least);

/// Ticks of a stage drawn with a width of `width` [px], without one at its end if the next stage begins there. No ticks
/// if only the zero at the start would be left.
Ticks ticksOfStage(const TimeAxis::Span& span, double width);

class TimeTrack : public QWidget {
    Q_OBJECT

public:
    TimeTrack(const Themes& themes, TimeCursor& cursor, QWidget* parent = nullptr);

    /// Shows all stages.
    void zoomOut();
    double low() const { return low_; }
    double high() const { return high_; }

    static constexpr double inset = 16.0;  // margin at both ends of the axis [px]

    QSize sizeHint() const override { return {600, 76}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    enum class Drag { Nothing, Time, CursorB, Pan };

    double xOf(double place) const;
    double placeAt(double x) const;
    void setWindow(double low, double high);
    void takeRun();
    void scrubTo(double x);
    const std::vector<PlacedEvent>& marks() const;
    QString tipAt(const QPointF& at) const;

    void paintBands(QPainter& painter) const;
    void paintBand(QPainter& painter, const TimeAxis::Span& span) const;
    void paintStage(QPainter& painter, const Stage& stage, double from, double to, double done) const;
    void paintTicks(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintCounts(QPainter& painter, const std::vector<PlacedEvent>& placed) const;
    void paintCursors(QPainter& painter) const;
    void paintFlag(QPainter& painter, double x, const QString& letter, bool filled) const;

    const Themes& themes_;
    TimeCursor& cursor_;
    TimeAxis axis_;
    double low_ = 0.0, high_ = 1.0;  // part of the axis that is shown
    Drag drag_ = Drag::Nothing;
    QPointF dragFrom_;
    double dragLow_ = 0.0;

    struct Laid {
        std::size_t events = 0;
        double low = 0.0, high = 0.0;
        int width = 0;
        bool valid = false;
    };
    mutable Laid laid_;  // state for which `marks_` was computed
    mutable std::vector<PlacedEvent> marks_;
    mutable std::vector<int> columns_;  // pixel columns that contain events, in ascending order
};

}  // namespace keyblock
