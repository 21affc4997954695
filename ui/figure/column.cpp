// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/column.h"

#include "solver/results/result_names.h"
#include "ui/figure/mark_painter.h"
#include "ui/figure/paper.h"
#include "ui/picture/captions.h"
#include "ui/picture/section/shown_numbers.h"
#include "ui/picture/section/tick_labels.h"

#include <QLinearGradient>
#include <QPainter>

#include <algorithm>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double shortestArrow = 0.25;  // [mm]
constexpr double columnRow = 3.3, columnNoteRow = 2.9, barHeight = 2.3, tip = 1.5;  // [mm]

QColor qt(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

/// The bar's outline, with a triangle at each end that values exceed.
std::vector<Point> outlineOf(const LegendBar& bar, const Point& at, double from, double to) {
    std::vector<Point> points{at + Point(from, 0.0), at + Point(to, 0.0)};
    if (bar.goesAbove) points.push_back(at + Point(to + tip, 0.5 * barHeight));
    points.push_back(at + Point(to, barHeight));
    points.push_back(at + Point(from, barHeight));
    if (bar.goesBelow) points.push_back(at + Point(from - tip, 0.5 * barHeight));
    return points;
}

void fillBar(Ink& ink, const LegendBar& bar, const Point& at, double from, double to) {
    QLinearGradient gradient((at.x() + from) * unitsPerMm, 0.0, (at.x() + to) * unitsPerMm, 0.0);
    QGradientStops stops;
    for (const auto& [share, colour] : bar.stops(false)) stops.append({share, qt(colour)});
    gradient.setStops(stops);
    QPolygonF polygon;
    for (const Point& point : outlineOf(bar, at, from, to))
        polygon.push_back(QPointF(point.x() * unitsPerMm, point.y() * unitsPerMm));
    ink.painter().setPen(Qt::NoPen);
    ink.painter().setBrush(gradient);
    ink.painter().drawPolygon(polygon);
    ink.polygon(outlineOf(bar, at, from, to), {}, Stroke{0.13, black});
}

/// Draws the names of limits above the bar. A name that would overlap the one before it is omitted, but its tick stays.
void drawLimits(Ink& ink, const LegendBar& bar, const Point& at, const std::function<double(double)>& placeOf,
                double width) {
    double free = 0.0;
    for (const auto& [value, name] : bar.limits) {
        const double place = placeOf(value), half = 0.5 * textWidth(name, text_style::tick);
        ink.line(at + Point(place, -0.8), at + Point(place, barHeight), {0.25, black});
        const double centre = std::min(place, width - half);
        if (centre - half < free) continue;
        ink.text(at + Point(centre, -1.3), name, text_style::tick, Align::Centre);
        free = centre + half + 0.3;
    }
}

void drawBar(Ink& ink, const LegendBar& bar, const Point& corner, double width,
             const std::vector<std::string>& notes) {
    double y = corner.y() + 2.0;
    ink.text({corner.x(), y}, bar.title + (bar.unit.empty() ? "" : " (" + bar.unit + ")"), text_style::heading);
    y += bar.limits.empty() ? 1.4 : 4.4;
    const double from = bar.goesBelow ? tip : 0.0, to = width - (bar.goesAbove ? tip : 0.0);
    const auto placeOf = [&](double value) { return from + (to - from) * bar.shareOf(value); };
    const Point at(corner.x(), y);
    fillBar(ink, bar, at, from, to);
    drawLimits(ink, bar, at, placeOf, width);
    const auto widthOf = [](const std::string& text) { return textWidth(text, text_style::tick); };
    for (const TickLabel& tick : tickLabels(bar, {from, to, width, 0.8, widthOf})) {
        ink.line(at + Point(tick.place, barHeight), at + Point(tick.place, barHeight + 0.7), {0.13, black});
        ink.text(at + Point(tick.middle, barHeight + 3.0), tick.text, text_style::tick, Align::Centre);
    }
    y += barHeight + 3.0;
    for (const std::string& note : notes) ink.text({corner.x(), y += columnNoteRow}, note, text_style::note);
}

/// A row of the event list: the heading of a stage, or an entry with its text on up to two lines.
struct EventRow {
    const EventEntry* entry = nullptr;
    std::vector<std::string> lines;

    double height() const { return columnRow + columnNoteRow * static_cast<double>(lines.size() - 1); }
};

/// Width of the time column [mm], which fits all times, so that the texts of all rows are aligned.
double timeRoom(const Scene& scene, const EventList& events) {
    double room = 6.5;
    for (const EventEntry& entry : events.entries)
        room = std::max(room, textWidth(shortTimeText(scene, entry.stage, entry.time), text_style::body));
    return room + 1.0;
}

std::string forceOf(const EventEntry& entry) { return entry.bolt < 0 ? "" : forceText(entry.force, {}); }

/// Text of an entry between its time and its force. \param width of the texts and forces [mm]
std::vector<std::string> linesOf(const EventEntry& entry, double width) {
    const double room = width - textWidth(forceOf(entry), text_style::body) - 1.0;
    const std::string name = elided(entry.subject, text_style::body, room, true);
    return wrapped(name + (entry.count > 1 ? ": " : " ") + entry.what, text_style::body, room, 2);
}

std::vector<EventRow> rowsOf(const Scene& scene, const EventList& events, double textsWidth) {
    std::vector<EventRow> rows;
    int stage = -1;
    for (const EventEntry& entry : events.entries) {
        if (entry.stage != stage && scene.stages.size() > 1)
            rows.push_back({nullptr, {stageTitle(scene, entry.stage)}});
        stage = entry.stage;
        rows.push_back({&entry, linesOf(entry, textsWidth)});
    }
    return rows;
}

constexpr double timesFrom = 3.6;  // [mm] space for the number of an event

void drawEntry(Ink& ink, const Scene& scene, const EventRow& row, const Point& at, double width, double timeRoom) {
    const EventEntry& entry = *row.entry;
    drawNumber(ink, at + Point(1.35, -0.72), entry.number, 1.35, {1.8, true});
    ink.text(at + Point(width, 0.0), forceOf(entry), text_style::body, Align::Right);
    ink.text(at + Point(timesFrom, 0.0), shortTimeText(scene, entry.stage, entry.time), text_style::body);
    double y = 0.0;
    for (const std::string& line : row.lines) {
        ink.text(at + Point(timesFrom + timeRoom, y), line, text_style::body);
        y += columnNoteRow;
    }
}

std::vector<std::string> notesOf(const EventList& events, double width) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& note) {
        if (!note.empty())
            for (const std::string& line : wrapped(note, text_style::note, width, 3)) notes.push_back(line);
    };
    if (events.leftOut > 0) add("and " + std::to_string(events.leftOut) + " more, in the table next to this figure");
    add(events.counted);
    if (events.entries.empty() && events.counted.empty()) add("none so far");
    return notes;
}

}  // namespace

ColumnItem barItem(const LegendBar& bar, double width) {
    std::vector<std::string> notes;
    for (const std::string& note : bar.notes)
        if (!note.empty())
            for (const std::string& line : wrapped(note, text_style::note, width, 2)) notes.push_back(line);
    const double height = 2.0 + (bar.limits.empty() ? 1.4 : 4.4) + barHeight + 3.0 +
                          columnNoteRow * static_cast<double>(notes.size());
    return {height, [&bar, width, notes](Ink& ink, const Point& at) { drawBar(ink, bar, at, width, notes); }};
}

void drawArrow(Ink& ink, ArrowShape shape, const Point& at, const Point& length) {
    const double size = length.norm();
    if (size < shortestArrow) return;
    if (shape != ArrowShape::Arrow)
        return ink.line(at - 0.5 * length, at + 0.5 * length,
                        {0.2, shape == ArrowShape::Tension ? error : black});
    const Point tip = at + length, along = length / size, across = turnLeft(along);
    const double head = std::min(0.9, 0.4 * size);
    ink.line(at, tip - 0.7 * head * along, {0.2, black});
    ink.polygon({tip, tip - head * along + 0.4 * head * across, tip - head * along - 0.4 * head * across}, black, {});
}

ColumnItem arrowItem(const ArrowField& field, double scale, double width) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& note) {
        for (const std::string& line : wrapped(note, text_style::note, width, 2)) notes.push_back(line);
    };
    for (const std::string& note : field.notes) add(note);
    add("largest in this frame " + numberText(field.largest) + " " + field.unit);
    return {6.0 + columnNoteRow * static_cast<double>(notes.size()), [&field, scale, notes](Ink& ink, const Point& at) {
                ink.text(at + Point(0.0, 2.0), field.title, text_style::heading);
                double shown = roundHalvable(0.45 * field.largest);
                if (shown > field.largest) shown *= 0.5;
                const Point length(shown * scale, 0.0);
                const bool arrow = field.marks.front().shape == ArrowShape::Arrow;
                drawArrow(ink, arrow ? ArrowShape::Arrow : ArrowShape::Compression,
                          at + Point(arrow ? 0.0 : 0.5 * length.x(), 4.8), length);
                ink.text(at + Point(length.x() + 1.5, 5.5), numberText(shown) + " " + field.unit, text_style::body);
                double y = 6.0;
                for (const std::string& note : notes) ink.text(at + Point(0.0, y += columnNoteRow), note, text_style::note);
            }};
}

ColumnItem keyItem(std::vector<MarkKind> kinds, double width) {
    const double rows = static_cast<double>((kinds.size() + 1) / 2);
    return {2.0 + columnRow * rows, [kinds, width](Ink& ink, const Point& at) {
                ink.text(at + Point(0.0, 2.0), "Bolt nodes", text_style::heading);
                for (std::size_t i = 0; i < kinds.size(); ++i) {
                    const Point place = at + Point(i % 2 ? 0.52 * width : 0.0,
                                                   2.0 + columnRow * static_cast<double>(i / 2 + 1));
                    const bool plate = kinds[i] == MarkKind::Plate || kinds[i] == MarkKind::PlateLost;
                    const Point along = plate ? Point(0.0, 1.0) : Point(1.0, 0.0);
                    const Point lift = kinds[i] == MarkKind::PlateLost ? Point(1.2, -1.6) : Point(1.2, -0.7);
                    drawMark(ink, kinds[i], place + lift, along);
                    ink.text(place + Point(3.6, 0.0), nameOf(kinds[i]), text_style::body);
                }
            }};
}

ColumnItem eventsItem(const Scene& scene, const EventList& events, double width) {
    const double room = timeRoom(scene, events);
    const std::vector<EventRow> rows = rowsOf(scene, events, width - timesFrom - room);
    const std::vector<std::string> notes = notesOf(events, width);
    double listed = rows.empty() ? 0.0 : 2.4;
    for (const EventRow& row : rows) listed += row.height();
    const double height = 2.0 + listed + columnNoteRow * static_cast<double>(notes.size());
    return {height, [&scene, rows, notes, width, listed, room](Ink& ink, const Point& at) {
                ink.text(at + Point(0.0, 2.0), "Events", text_style::heading);
                double y = 3.2;
                if (!rows.empty()) ink.line(at + Point(0.0, y), at + Point(width, y), {0.13, black});
                for (const EventRow& row : rows) {
                    const Point first = at + Point(0.0, y + columnRow - 0.4);
                    if (row.entry) drawEntry(ink, scene, row, first, width, room);
                    else ink.text(first, row.lines.front(), text_style::note);
                    y += row.height();
                }
                if (!rows.empty()) ink.line(at + Point(0.0, y + 0.6), at + Point(width, y + 0.6), {0.13, black});
                y = 2.0 + listed;
                for (const std::string& note : notes) ink.text(at + Point(0.0, y += columnNoteRow), note, text_style::note);
            }};
}

}  // namespace keyblock
