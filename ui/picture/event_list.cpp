// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/event_list.h"

#include "solver/results/event_groups.h"
#include "solver/results/result_names.h"
#include "ui/picture/captions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

/// Severity, from events that a picture may omit to those that it must show.
int gravity(EventKind kind) {
    switch (kind) {
        case EventKind::JointSlip:
        case EventKind::JointOpen:
        case EventKind::Restick: return 0;
        case EventKind::Debonding: return 1;
        case EventKind::Yield:
        case EventKind::Hinge: return 2;
        case EventKind::PulledOut:
        case EventKind::PlateLoss: return 3;
        case EventKind::TensileRupture:
        case EventKind::ShearRupture:
        case EventKind::BoltLoss: return 4;
        case EventKind::BlockFalls:
        case EventKind::Collapse: break;
    }
    return 5;
}

std::string several(int count, const char* one, const char* more) {
    return count == 1 ? one : std::to_string(count) + " " + more;
}

std::string wordsOf(EventKind kind, int n) {
    switch (kind) {
        case EventKind::Debonding: return several(n, "debonds at one node", "nodes debond");
        case EventKind::Yield: return several(n, "yields", "elements yield");
        case EventKind::Hinge: return several(n, "forms a plastic hinge", "plastic hinges");
        case EventKind::TensileRupture: return several(n, "ruptures (tension)", "ruptures (tension)");
        case EventKind::ShearRupture: return several(n, "ruptures (shear)", "ruptures (shear)");
        case EventKind::PlateLoss: return "loses its face plate";
        case EventKind::BoltLoss: return "is lost";
        case EventKind::PulledOut: return several(n, "has one node pulled out", "nodes pulled out");
        case EventKind::BlockFalls: return "falls";
        case EventKind::Collapse: return "collapse";
        default: return std::string(wordOf(kind));
    }
}

double forceOf(const Event& event) {
    return std::abs(event.kind == EventKind::ShearRupture ? event.shearForce : event.axialForce);
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

/// One entry for each bolt and kind in a stage; one for each block.
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
    const auto add = [&](EventKind kind, const std::string& one, const std::string& more) {
        if (const long n = counts.of(kind); n > 0)
            text += (text.empty() ? "" : ", ") + std::to_string(n) + " " + (n == 1 ? one : more);
    };
    add(EventKind::JointSlip, "joint slip", "joint slips");
    add(EventKind::JointOpen, "joint opening", "joint openings");
    add(EventKind::Restick, "bond re-stick", "bond re-sticks");
    return text;
}

}  // namespace

bool isGrave(EventKind kind) { return gravity(kind) >= 3; }

std::vector<Event> eventsUntil(std::vector<Event> events, const FrameHead& frame) {
    events.resize(std::min(events.size(), static_cast<std::size_t>(frame.events)));
    return events;
}

EventList eventList(const RunSource& run, std::span<const Event> events, std::size_t most) {
    EventList list{grouped(run, events), 0, countedText(events)};
    while (list.entries.size() > most) {
        const auto least = std::min_element(list.entries.rbegin(), list.entries.rend(),
                                            [](const EventEntry& a, const EventEntry& b) {
                                                return gravity(a.kind) < gravity(b.kind);
                                            });
        list.entries.erase(std::next(least).base());
        ++list.leftOut;
    }
    int number = 0;
    for (EventEntry& entry : list.entries) {
        entry.number = ++number;
        entry.what = wordsOf(entry.kind, entry.count);
    }
    return list;
}

}  // namespace keyblock
