// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/event_groups.h"

#include <algorithm>

namespace keyblock {

namespace {

void join(std::string& text, const std::string& part) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
}

}  // namespace

std::vector<EventKind> kindsOf(EventGroup group) {
    std::vector<EventKind> kinds;
    for (const EventKindRow& row : eventKinds)
        if (row.group == group) kinds.push_back(row.kind);
    return kinds;
}

EventCounts::EventCounts(std::span<const Event> events) {
    for (const Event& event : events) add(event);
}

long EventCounts::of(EventGroup group) const {
    long count = 0;
    for (const EventKind kind : kindsOf(group)) count += of(kind);
    return count;
}

std::string EventCounts::kindText(EventKind kind) const {
    const long count = of(kind);
    if (count == 0) return {};
    return std::to_string(count) + " " + std::string(count == 1 ? rowOf(kind).title : rowOf(kind).plural);
}

std::string EventCounts::kindsText(EventGroup group) const {
    std::string text;
    for (const EventKind kind : kindsOf(group)) join(text, kindText(kind));
    return text;
}

/// Names the group only if several of its kinds of event occurred.
std::string EventCounts::text() const {
    std::string all;
    for (const EventGroupRow& group : eventGroups) {
        const std::string kinds = kindsText(group.group);
        const bool several =
            std::ranges::count_if(kindsOf(group.group), [&](EventKind kind) { return of(kind) > 0; }) > 1;
        join(all, several ? std::to_string(of(group.group)) + " " + std::string(group.title) + " (" + kinds + ")" : kinds);
    }
    return all;
}

}  // namespace keyblock
