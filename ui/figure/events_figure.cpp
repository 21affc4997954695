// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A row for each kind of event that occurred, on the time axis of the whole run, with
// the stages above. Below is a list of the failures of bolts and of the blocks that
// fell, in which several events of a kind are one entry.
#include "ui/figure/events_figure.h"

#include "solver/results/tables.h"
#include "solver/results/result_names.h"
#include "ui/figure/mark_painter.h"
#include "ui/figure/paper.h"
#include "ui/figure/sheet.h"
#include "ui/picture/captions.h"
#include "ui/picture/event_list.h"
#include "ui/picture/run_time.h"
#include "ui/picture/section/shown_numbers.h"
#include "ui/picture/ticks.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double kindRow = 4.6, listRow = 3.6, bandHeight = 4.4, timeAxisRoom = 9.0;  // [mm]
constexpr double namesWidth = 27.0, counts = 12.0;  // columns left and right of the timeline [mm]
constexpr double markDistance = 1.2;  // [mm]
constexpr std::size_t mostListed = 40;

struct KindRow {
    const EventKindRow* kind = nullptr;
    std::vector<double> times;  // positions on the time axis, in ascending order
};

std::vector<KindRow> kindRows(const std::vector<Event>& events, const RunTime& time) {
    std::vector<KindRow> rows;
    for (const EventKindRow& kind : eventKinds) {
        KindRow row{&kind, {}};
        for (const Event& event : events)
            if (event.kind == kind.kind) row.times.push_back(time.at(event.stage, event.time));
        if (!row.times.empty()) rows.push_back(std::move(row));
    }
    return rows;
}

/// Draws the mark of an event, or a tick if its kind occurs by the hundred.
void drawEvent(Ink& ink, EventMark mark, const Point& at) {
    switch (mark) {
        case EventMark::Debonding: return drawMark(ink, MarkKind::Slipping, at, {1.0, 0.0}, true);
        case EventMark::Yield: return drawMark(ink, MarkKind::Yielded, at, {1.0, 0.0});
        case EventMark::Rupture: return drawMark(ink, MarkKind::Ruptured, at, {1.0, 0.0});
        case EventMark::Plate: return drawMark(ink, MarkKind::PlateLost, at - Point(0.0, 0.9), {0.0, 1.0});
        case EventMark::PulledOut:
            ink.polyline({at + Point(-0.7, -0.2), at + Point(0.0, -0.9), at + Point(0.7, -0.2)}, {0.28, error});
            return ink.line(at + Point(0.0, -0.8), at + Point(0.0, 0.9), {0.28, error});
        case EventMark::Falls:
            return ink.polygon({at + Point(-0.9, -0.7), at + Point(0.9, -0.7), at + Point(0.0, 0.9)}, error, {});
        case EventMark::Slip:
        case EventMark::Opening:
        case EventMark::Restick: return ink.line(at + Point(0.0, -1.1), at + Point(0.0, 1.1), {0.13, softText});
    }
}

class TimeLine {
public:
    TimeLine(const RunTime& time, const Scene& scene, std::vector<KindRow> rows, double left, double right)
        : time_(time), scene_(scene), rows_(std::move(rows)), left_(left), right_(right) {}

    double height() const { return bandHeight + kindRow * static_cast<double>(rows_.size()) + timeAxisRoom; }

    void draw(Ink& ink, double top) const {
        drawStages(ink, top);
        double y = top + bandHeight + 0.5 * kindRow;
        for (const KindRow& row : rows_) {
            drawRow(ink, row, y);
            y += kindRow;
        }
        drawAxis(ink, y - 0.5 * kindRow);
    }

private:
    double at(double time) const { return left_ + (right_ - left_) * time / time_.end(); }

    void drawStages(Ink& ink, double top) const {
        const double bottom = top + bandHeight + kindRow * static_cast<double>(rows_.size());
        bool tinted = false;
        for (const StageSpan& span : time_.stages()) {
            const double from = at(span.from), to = at(span.to);
            ink.box({{from, top}, {to, top + bandHeight - 0.8}}, tinted ? rgb(0xECEEF1) : rgb(0xF8F9FA),
                    Stroke{0.1, axis});
            if (span.from > 0.0) ink.line({from, top}, {from, bottom}, {0.1, axis});
            const std::string name = elided(stageName(scene_, span.stage), text_style::body, to - from - 1.2, true);
            if (textWidth(name, text_style::body) <= to - from - 1.2)
                ink.text({0.5 * (from + to), top + 2.5}, name, text_style::body, Align::Centre);
            tinted = !tinted;
        }
    }

    void drawRow(Ink& ink, const KindRow& row, double y) const {
        ink.line({left_, y}, {right_, y}, {0.1, grid});
        ink.text({left_ - 2.0, y + 0.7}, std::string(row.kind->title), text_style::body, Align::Right);
        ink.text({right_ + counts - 1.0, y + 0.7}, numberText(static_cast<double>(row.times.size()), 0),
                 text_style::body, Align::Right);
        const bool isTick = isMinor(row.kind->kind);
        double free = -1e9;
        for (const double time : row.times) {
            const double x = at(time);
            if (x < free) continue;
            drawEvent(ink, row.kind->mark, {x, y});
            free = x + (isTick ? 0.3 : markDistance);
        }
    }

    void drawAxis(Ink& ink, double y) const {
        ink.line({left_, y}, {right_, y}, {0.15, axis});
        const auto widthOf = [](const std::string& text) { return textWidth(text, text_style::note) + 1.2; };
        for (const AxisTick& tick : stageTicks(time_.stages(), (right_ - left_) / time_.end(), widthOf)) {
            ink.line({at(tick.at), y}, {at(tick.at), y + 0.7}, {0.15, axis});
            ink.text({at(tick.at), y + 3.1}, tick.text, text_style::note, Align::Centre);
        }
        ink.text({0.5 * (left_ + right_), y + 6.2}, time_.title(), text_style::body, Align::Centre);
    }

    const RunTime& time_;
    const Scene& scene_;
    std::vector<KindRow> rows_;
    double left_, right_;
};

/// A table with one column each for number, stage (if there are several), time, object and event, and force.
class EventTable {
public:
    EventTable(const Scene& scene, const EventList& list, double left, double width)
        : scene_(scene), list_(list), left_(left), width_(width) {
        for (const EventEntry& entry : list.entries)
            timeWidth_ = std::max(timeWidth_, textWidth(timesOf(entry), text_style::body));
        timeWidth_ = std::min(timeWidth_, 0.3 * width);
        if (scene.stages.size() > 1) stageWidth_ = 0.16 * width;
    }

    double height() const {
        if (list_.entries.empty()) return 0.0;
        return 6.0 + listRow * static_cast<double>(list_.entries.size() + (list_.leftOut > 0 ? 1 : 0));
    }

    void draw(Ink& ink, double y) const {
        if (list_.entries.empty()) return;
        if (stageWidth_ > 0.0) cell(ink, y, numberRoom, "Stage", text_style::number, stageWidth_);
        cell(ink, y, timeAt(), "Time", text_style::number, timeWidth_);
        const std::string force = width_ < 100.0 ? "Force before" : "Force before failure";
        cell(ink, y, whoAt(), "Event", text_style::number,
             width_ - whoAt() - textWidth(force, text_style::number) - 2.0);
        ink.text({left_ + width_, y}, force, text_style::number, Align::Right);
        ink.line({left_, y + 1.0}, {left_ + width_, y + 1.0}, {0.13, black});
        for (const EventEntry& entry : list_.entries) row(ink, entry, y += listRow + (&entry == list_.entries.data()));
        if (list_.leftOut > 0)
            ink.text({left_, y += listRow}, "and " + std::to_string(list_.leftOut) + " more, in the table next to this figure",
                     text_style::note);
        ink.line({left_, y + 1.2}, {left_ + width_, y + 1.2}, {0.13, black});
    }

private:
    static constexpr double numberRoom = 5.0;  // [mm]
    double timeAt() const { return numberRoom + (stageWidth_ > 0.0 ? stageWidth_ + 2.0 : 0.0); }
    double whoAt() const { return timeAt() + timeWidth_ + 3.0; }

    std::string timesOf(const EventEntry& entry) const {
        const std::string first = timeText(scene_, entry.stage, entry.time);
        const std::string last = timeText(scene_, entry.stage, entry.lastTime);
        return entry.count > 1 && first != last ? first + " to " + last : first;
    }

    void cell(Ink& ink, double y, double x, const std::string& text, const TextStyle& style, double room) const {
        ink.text({left_ + x, y}, elided(text, style, room, true), style);
    }

    void row(Ink& ink, const EventEntry& entry, double y) const {
        drawNumber(ink, {left_ + 1.4, y - 0.72}, entry.number, 1.4, {1.8, true});
        if (stageWidth_ > 0.0)
            cell(ink, y, numberRoom, stageName(scene_, entry.stage), text_style::body, stageWidth_);
        cell(ink, y, timeAt(), timesOf(entry), text_style::body, timeWidth_ + 0.01);
        const std::string force = entry.bolt < 0 ? "" : forceText(entry.force, {});
        ink.text({left_ + width_, y}, force, text_style::body, Align::Right);
        const double room = width_ - whoAt() - textWidth(force, text_style::body) - 2.0;
        const double forName = std::max(10.0, room - textWidth(": " + entry.what, text_style::body));
        const std::string name = elided(entry.subject, text_style::body, forName, true);
        cell(ink, y, whoAt(), name + (entry.count > 1 ? ": " : " ") + entry.what, text_style::body, room);
    }

    const Scene& scene_;
    const EventList& list_;
    double left_, width_;
    double stageWidth_ = 0.0;  // 0: the scene has a single stage
    double timeWidth_ = 6.0;
};

std::vector<Event> shownEvents(const RunSource& run, const FigureRequest& request) {
    std::vector<Event> events = run.events();
    if (request.filter.when)
        if (const auto frame = frameAt(run, request.filter)) events = eventsUntil(events, run.frames()[*frame]);
    if (request.filter.bolt)
        std::erase_if(events, [&](const Event& event) { return event.bolt != *request.filter.bolt; });
    if (request.filter.stage && !request.filter.when)
        std::erase_if(events, [&](const Event& event) { return event.stage != *request.filter.stage; });
    return events;
}

std::string subtitleFor(const FigureRequest& request, const RunSource& run, const EventList& list, std::size_t count) {
    std::string text = numberText(static_cast<double>(count), 0) + (count == 1 ? " event" : " events");
    if (request.filter.bolt) text += " of bolt " + boltName(run.scene(), *request.filter.bolt);
    return text + (list.counted.empty() ? "." : "; not listed: " + list.counted + ".");
}

}  // namespace

Figure paintEvents(const RunSource& run, const FigureRequest& request) {
    if (request.quantity) throw CannotDraw("an events figure shows no quantity; omit --quantity");
    const RunTime time(run);
    if (!(time.end() > 0.0)) throw CannotDraw("the run has not begun, so it has no events");
    const std::vector<Event> events = shownEvents(run, request);
    const EventList list = eventList(run, events, mostListed);
    const std::string own = "Events: " + (run.scene().title.empty() ? request.runName : run.scene().title);
    const std::string title = request.title.empty() ? own : request.title;
    const Sheet sheet(request.width, title, subtitleFor(request, run, list, events.size()),
                      warningsOf(run, std::nullopt));
    const TimeLine line(time, run.scene(), kindRows(events, time), margin + namesWidth,
                        request.width - margin - counts);
    const EventTable table(run.scene(), list, margin, sheet.inner());
    const double height = std::ceil(sheet.heightAround(line.height() + table.height()));
    Paper paper(request.format, request.width, height, request.dpi, title);
    Ink ink(paper.painter());
    sheet.draw(ink, height, footOf(run, request, std::nullopt, height));
    line.draw(ink, sheet.top());
    table.draw(ink, sheet.top() + line.height() + 4.0);
    TableFilter filter;
    filter.bolt = request.filter.bolt;
    if (!request.filter.when) filter.stage = request.filter.stage;
    const auto write = [&run, filter](std::ostream& out) { writeTable(TableKind::Events, run, filter, out); };
    return {paper.finish(), {{"", write}}};
}

}  // namespace keyblock
