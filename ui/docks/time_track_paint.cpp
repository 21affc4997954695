// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Painting of the timeline: bands, ticks, marks and flags, in px.
#include "solver/results/result_names.h"
#include "ui/canvas/call_out.h"
#include "ui/docks/event_marks.h"
#include "ui/docks/time_track.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double bandTop = 13.0, bandHeight = 20.0, marksAt = 46.0, axisAt = 59.0, labelsAt = 71.0;  // [px]
constexpr double perTick = 62.0;  // [px]

QColor clear(QColor colour, double opacity) {
    colour.setAlphaF(opacity);
    return colour;
}

/// Kind of a stage, shown next to its name.
QString natureOf(const Stage& stage) {
    if (stage.kind == StageKind::Dynamic)
        return TimeTrack::tr("dynamic · %1 s").arg(Display::number(stage.duration, 3));
    if (stage.relaxation) return TimeTrack::tr("static · relaxation");
    return TimeTrack::tr("static");
}

const char* iconOf(const StageRecord* record, bool goesOn) {
    if (!record) return "not-yet";
    if (!record->ended) return goesOn ? "running" : "warning";
    switch (record->result.outcome) {
        case Outcome::Failed: return "error";
        case Outcome::Stopped:
        case Outcome::Limit:
        case Outcome::Collapse:
        case Outcome::Displaced:
        case Outcome::Undecided: return "warning";
        default: return record->result.unstable.empty() ? "ok" : "warning";
    }
}

/// Time within a stage that was reached.
double reachedIn(const LiveRun& run, int stage, const StageRecord* record) {
    double reached = record && record->ended ? record->result.time : 0.0;
    for (const FrameHead& head : run.frames())
        if (head.stage == stage) reached = std::max(reached, head.time);
    if (const Frame* newest = run.newest().frame.get(); newest && newest->stage == stage)
        reached = std::max(reached, newest->time);
    return reached;
}

const StageRecord* recordOf(const LiveRun& run, int stage) {
    const auto& records = run.stageList();
    const auto found = std::find_if(records.begin(), records.end(),
                                    [&](const StageRecord& record) { return record.result.stage == stage; });
    return found == records.end() ? nullptr : &*found;
}

/// Hatches the part of a stage that has not been computed, or never will be.
void paintUndone(QPainter& painter, const Theme& theme, double from, double to) {
    painter.save();
    painter.setClipRect(QRectF(from, bandTop, to - from, bandHeight), Qt::IntersectClip);
    painter.setPen(QPen(theme.separator, 1.0));
    for (double x = from - bandHeight; x < to; x += 7.0)
        painter.drawLine(QPointF(x, bandTop + bandHeight), QPointF(x + bandHeight, bandTop));
    painter.restore();
}

QColor colourOf(const QString& icon, const Theme& theme) {
    if (icon == "ok") return theme.ok;
    if (icon == "error") return theme.error;
    if (icon == "warning") return theme.warning;
    return icon == "running" ? theme.accent : theme.text3;
}

}  // namespace

Ticks ticksOfStage(const TimeAxis::Span& span, double width) {
    Ticks ticks = roundTicks({0.0, span.duration}, std::clamp(static_cast<int>(width / perTick), 2, 400));
    if (span.to < 1.0) std::erase_if(ticks.values, [&](double value) { return value >= span.duration * (1.0 - 1e-9); });
    if (ticks.values.size() < 2) ticks.values.clear();
    return ticks;
}

void TimeTrack::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    if (axis_.isEmpty()) return;
    painter.setRenderHint(QPainter::Antialiasing);
    paintBands(painter);
    paintTicks(painter);
    painter.setClipRect(QRectF(inset - 8.0, 0.0, width() - 2.0 * inset + 16.0, height()));
    paintMarks(painter);
    paintCursors(painter);
}

void TimeTrack::paintBands(QPainter& painter) const {
    painter.save();
    painter.setClipRect(QRectF(inset, 0.0, width() - 2.0 * inset, height()));
    for (const TimeAxis::Span& span : axis_.spans()) paintBand(painter, span);
    painter.restore();
}

void TimeTrack::paintBand(QPainter& painter, const TimeAxis::Span& span) const {
    const Theme& theme = themes_.current();
    const double left = std::max(xOf(span.from), -10.0), right = std::min(xOf(span.to), width() + 10.0);
    if (right < 0.0 || left > width()) return;
    const StageRecord* record = recordOf(*cursor_.run(), span.stage);
    const bool current = record && !record->ended && cursor_.goesOn();
    const double reached = reachedIn(*cursor_.run(), span.stage, record);
    const double done = std::clamp(xOf(axis_.at(span.stage, reached)), left, right);
    const QRectF computed(left, bandTop, done - left, bandHeight);
    painter.fillRect(computed, current ? theme.accentSoft : theme.header);
    if (current) painter.fillRect(computed, clear(theme.accent, 0.16));
    if (right - done > 1.0) paintUndone(painter, theme, done, right);
    painter.setPen(QPen(current ? clear(theme.accent, 0.45) : theme.border, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(left, bandTop, right - left, bandHeight).adjusted(0.5, 0.5, -0.5, -0.5));
    const double from = std::max(left, inset) + 8.0, to = std::min(right, width() - inset) - 6.0;
    if (to - from < 18.0) return;
    const QString icon = iconOf(record, cursor_.goesOn());
    themes_.icon(icon, colourOf(icon, theme)).paint(&painter, QRect(int(from), int(bandTop) + 3, 14, 14));
    paintStage(painter, cursor_.run()->scene().stages[span.stage], from, to,
               right - done > 1.0 ? std::max(done, from) : to);
}

/// Paints the name and kind of the stage. If there is room, a note at the end, after `done`, says that this part is not
/// computed.
void TimeTrack::paintStage(QPainter& painter, const Stage& stage, double from, double to, double done) const {
    const Theme& theme = themes_.current();
    const QFont small = screenFont(11);
    const QString unmade = cursor_.goesOn() ? tr("not yet computed") : tr("not computed");
    const double unmadeWidth = QFontMetricsF(small).horizontalAdvance(unmade) + 10.0;
    const bool tells = to - done > unmadeWidth + 4.0 && to - from > unmadeWidth + 90.0;
    const double end = tells ? to - unmadeWidth : to;
    double x = from + 20.0;
    const auto write = [&](const QString& text, const QFont& font, const QColor& colour) {
        if (end - x < 24.0) return;
        const QFontMetricsF metrics(font);
        const QString shown = metrics.elidedText(text, Qt::ElideRight, end - x);
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(QRectF(x, bandTop, end - x, bandHeight), Qt::AlignVCenter | Qt::AlignLeft, shown);
        x += metrics.horizontalAdvance(shown) + 12.0;
    };
    write(QString::fromStdString(stage.name), screenFont(12, true), theme.text);
    const QString nature = natureOf(stage);
    if (x + QFontMetricsF(small).horizontalAdvance(nature) < end) write(nature, small, theme.text2);
    if (!tells) return;
    painter.setFont(small);
    painter.setPen(theme.text2);
    painter.drawText(QRectF(end, bandTop, unmadeWidth, bandHeight), Qt::AlignVCenter | Qt::AlignRight, unmade);
}

void TimeTrack::paintTicks(QPainter& painter) const {
    const Theme& theme = themes_.current();
    painter.setFont(screenFont(10));
    const QFontMetricsF metrics(painter.font());
    painter.setPen(QPen(theme.border, 1.0));
    painter.drawLine(QPointF(inset, axisAt), QPointF(width() - inset, axisAt));
    double free = 0.0;
    for (const TimeAxis::Span& span : axis_.spans()) {
        const double left = xOf(span.from), right = xOf(span.to);
        if (right < inset || left > width() - inset) continue;
        const Ticks ticks = ticksOfStage(span, right - left);
        const bool seconds = cursor_.run()->scene().stages[span.stage].kind ==
                             StageKind::Dynamic;
        for (const double value : ticks.values) {
            const double x = xOf(axis_.at(span.stage, value));
            if (x < inset - 0.5 || x > width() - inset + 0.5) continue;
            painter.setPen(QPen(theme.border, 1.0));
            painter.drawLine(QPointF(x, axisAt - (value == 0.0 ? 4.0 : 0.0)), QPointF(x, axisAt + 4.0));
            QString text = QString::fromStdString(numberText(value, value == 0.0 ? 0 : ticks.decimals));
            if (seconds && (value == 0.0 || value == ticks.values.back())) text += QStringLiteral(" s");
            const double wide = metrics.horizontalAdvance(text);
            const double at = value == 0.0 ? x + 3.0 : std::min(x - 0.5 * wide, width() - inset - wide);
            if (at < free) continue;
            painter.setPen(theme.text2);
            painter.drawText(QPointF(at, labelsAt), text);
            free = at + wide + 6.0;
        }
    }
}

void TimeTrack::paintMarks(QPainter& painter) const {
    const Theme& theme = themes_.current();
    const std::vector<PlacedEvent>& placed = marks();
    painter.setPen(QPen(theme.text3, 1.0));
    if (columns_.size() > placed.size())  // events without room are shown as ticks
        for (const int x : columns_) painter.drawLine(QPointF(x, axisAt - 3.0), QPointF(x, axisAt - 0.5));
    for (const PlacedEvent& mark : placed)
        if (mark.group == EventGroup::Rupture || mark.group == EventGroup::Plate) {
            painter.setPen(QPen(clear(theme.error, 0.3), 1.0));
            painter.drawLine(QPointF(mark.x, bandTop + bandHeight), QPointF(mark.x, axisAt));
        }
    for (const PlacedEvent& mark : placed) drawEventMark(painter, theme, rowOf(mark.group).mark, {mark.x, marksAt});
    paintCounts(painter, placed);
    for (const std::size_t frame : cursor_.bookmarks()) {
        const FrameHead& head = cursor_.run()->frames()[frame];
        const double x = xOf(axis_.at(head.stage, head.time));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.accent);
        const double y = bandTop - 1.0;
        const QVector<QPointF> ribbon{{x - 3.5, y - 8.0}, {x + 3.5, y - 8.0}, {x + 3.5, y}, {x, y - 3.0}, {x - 3.5, y}};
        painter.drawPolygon(QPolygonF(ribbon));
    }
}

/// Paints the number of events of each mark if it fits before the next mark.
void TimeTrack::paintCounts(QPainter& painter, const std::vector<PlacedEvent>& placed) const {
    painter.setFont(screenFont(10));
    painter.setPen(themes_.current().text2);
    const QFontMetricsF metrics(painter.font());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        if (placed[i].count < 2) continue;
        const QString count = QString::number(placed[i].count);
        const double from = placed[i].x + 7.0, wide = metrics.horizontalAdvance(count);
        const double end = i + 1 < placed.size() ? placed[i + 1].x - 7.0 : width() - 2.0;
        if (from + wide <= end) painter.drawText(QPointF(from, marksAt + 3.5), count);
    }
}

void TimeTrack::paintCursors(QPainter& painter) const {
    const Theme& theme = themes_.current();
    if (const auto b = cursor_.cursorB()) {
        const FrameHead& head = cursor_.run()->frames()[*b];
        const double x = std::round(xOf(axis_.at(head.stage, head.time))) + 0.5;
        painter.setPen(QPen(theme.text2, 1.0, Qt::CustomDashLine));
        QPen dashed(theme.text2, 1.2);
        dashed.setDashPattern({3.0, 2.5});
        painter.setPen(dashed);
        painter.drawLine(QPointF(x, bandTop), QPointF(x, axisAt + 1.0));
        paintFlag(painter, x, QStringLiteral("B"), false);
    }
    if (!cursor_.hasMoment()) return;
    const FrameHead now = cursor_.head();
    const double x = std::round(xOf(axis_.at(now.stage, now.time))) + 0.5;
    painter.setPen(QPen(theme.accent, 1.5));
    painter.drawLine(QPointF(x, bandTop - 2.0), QPointF(x, axisAt + 1.0));
    paintFlag(painter, x, QStringLiteral("A"), true);
}

/// Paints a flag with a letter; the flag points down to the line.
void TimeTrack::paintFlag(QPainter& painter, double x, const QString& letter, bool filled) const {
    const Theme& theme = themes_.current();
    const QVector<QPointF> corners{{x - 7.5, 0.5}, {x + 7.5, 0.5}, {x + 7.5, 8.5}, {x, 13.5}, {x - 7.5, 8.5}};
    painter.setPen(QPen(filled ? theme.accent : theme.text2, 1.0));
    painter.setBrush(filled ? theme.accent : theme.panel);
    painter.drawPolygon(QPolygonF(corners));
    painter.setFont(screenFont(10, true));
    painter.setPen(filled ? theme.onAccent : theme.text2);
    painter.drawText(QRectF(x - 7.5, 0.0, 15.0, 11.0), Qt::AlignCenter, letter);
}

}  // namespace keyblock
