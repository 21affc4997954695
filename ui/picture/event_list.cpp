// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/event_list.h"

#include "solver/results/event_groups.h"
#include "solver/results/result_names.h"
#include "ui/picture/captions.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

/// Says what happened; the text follows the name of the bolt or block.
std::string whatOf(const EventKindRow& kind, int count) {
    return count == 1 ? std::string(kind.once) : std::to_string(count) + " " + std::string(kind.more);
}

double forceOf(const Event& event) {
    return std::abs(rowOf(event.kind).isOfShear ? event.shearForce : event.axialForce);
}

EventEntry entryOf(const RunSource& run, const Event& event) {
    EventEntry entry;
    entry.kind = event.kind;
    entry.stage = event.stage;
    entry.time = entry.lastTime = event.time;
    entry.bolt = event.bolt;
    entry.block = event.block;
    entry.node = event.node;
    entry.element = event.element;
    entry.place = event.position;
    entry.force = forceOf(event);
    entry.when = timeText(run.scene(), event.stage, event.time);
    entry.subject = event.bolt >= 0 ? boltName(run.scene(), event.bolt) : blockName(run.blockNames(), event.block);
    return entry;
}

/// Makes one entry for each kind of event of a bolt in a stage, and one entry for each event of a block.
std::vector<EventEntry> grouped(const RunSource& run, std::span<const Event> events) {
    std::vector<EventEntry> entries;
    for (const Event& event : events) {
        if (isMinor(event.kind)) continue;
        const auto alike = std::find_if(entries.begin(), entries.end(), [&](const EventEntry& entry) {
            return event.bolt >= 0 && entry.bolt == event.bolt && entry.kind == event.kind &&
                   entry.stage == event.stage;
        });
        if (alike == entries.end()) {
            entries.push_back(entryOf(run, event));
            continue;
        }
        ++alike->count;
        alike->lastTime = event.time;
        alike->force = std::max(alike->force, forceOf(event));
    }
    return entries;
}

std::string countedText(std::span<const Event> events) {
    const EventCounts counts(events);
    std::string text;
    for (const EventKindRow& row : eventKinds)
        if (isMinor(row.kind) && counts.of(row.kind) > 0) text += (text.empty() ? "" : ", ") + counts.kindText(row.kind);
    return text;
}

}  // namespace

std::vector<Event> eventsUntil(std::vector<Event> events, const FrameHead& frame) {
    events.resize(std::min(events.size(), static_cast<std::size_t>(frame.events)));
    return events;
}

EventList eventList(const RunSource& run, std::span<const Event> events, std::size_t most) {
    EventList list{grouped(run, events), 0, countedText(events)};
    while (list.entries.size() > most) {
        const auto least = std::min_element(list.entries.rbegin(), list.entries.rend(),
                                            [](const EventEntry& a, const EventEntry& b) {
                                                return rowOf(a.kind).severity < rowOf(b.kind).severity;
                                            });
        list.entries.erase(std::next(least).base());
        ++list.leftOut;
    }
    int number = 0;
    for (EventEntry& entry : list.entries) {
        entry.number = ++number;
        entry.what = whatOf(rowOf(entry.kind), entry.count);
    }
    return list;
}

}  // namespace keyblock
