// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/event_groups.h"

#include "solver/results/result_names.h"

#include <algorithm>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, eventGroups> groupWords{"slip",    "debonding", "restick",    "yield",
                                                               "rupture", "plate",     "pulled out", "block falls"};

void join(std::string& text, const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
}

}  // namespace

EventGroup groupOf(EventKind kind) {
    switch (kind) {
        case EventKind::JointSlip:
        case EventKind::JointOpen: return EventGroup::Slip;
        case EventKind::Debonding: return EventGroup::Debonding;
        case EventKind::Restick: return EventGroup::Restick;
        case EventKind::Yield:
        case EventKind::Hinge: return EventGroup::Yield;
        case EventKind::TensileRupture:
        case EventKind::ShearRupture:
        case EventKind::BoltLoss: return EventGroup::Rupture;
        case EventKind::PlateLoss: return EventGroup::Plate;
        case EventKind::PulledOut: return EventGroup::PulledOut;
        case EventKind::BlockFalls:
        case EventKind::Collapse: break;
    }
    return EventGroup::Falls;
}

std::vector<EventKind> kindsOf(EventGroup group) {
    std::vector<EventKind> kinds;
    for (std::size_t k = 0; k < eventKindWords.size(); ++k)
        if (groupOf(static_cast<EventKind>(k)) == group) kinds.push_back(static_cast<EventKind>(k));
    return kinds;
}

std::string_view wordOf(EventGroup group) { return groupWords[static_cast<std::size_t>(group)]; }

bool isMinor(EventKind kind) {
    const EventGroup group = groupOf(kind);
    return group == EventGroup::Slip || group == EventGroup::Restick;
}

EventCounts::EventCounts(std::span<const Event> events) {
    for (const Event& event : events) add(event);
}

long EventCounts::of(EventGroup group) const {
    long count = 0;
    for (const EventKind kind : kindsOf(group)) count += of(kind);
    return count;
}

std::string EventCounts::kindsText(EventGroup group) const {
    std::string text;
    for (const EventKind kind : kindsOf(group))
        if (of(kind) > 0) join(text, std::to_string(of(kind)) + " " + std::string(wordOf(kind)));
    return text;
}

std::string EventCounts::text() const {
    std::string all;
    for (std::size_t g = 0; g < eventGroups; ++g) {
        const auto group = static_cast<EventGroup>(g);
        if (of(group) == 0) continue;
        const std::string own = std::to_string(of(group)) + " " + std::string(wordOf(group));
        const std::string kinds = kindsText(group);
        std::string plain = kinds;
        std::replace(plain.begin(), plain.end(), '-', ' ');
        join(all, plain == own ? own : own + " (" + kinds + ")");
    }
    return all;
}

}  // namespace keyblock
