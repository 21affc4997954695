// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Number of events of each kind and group, with the texts shown in the window's
// timeline, in `info` and in figures.
#pragma once

#include "solver/results/results.h"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace keyblock {

std::vector<EventKind> kindsOf(EventGroup group);

class EventCounts {
public:
    EventCounts() = default;
    explicit EventCounts(std::span<const Event> events);

    void add(const Event& event) { ++counts_[static_cast<std::size_t>(event.kind)]; }
    long of(EventKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
    long of(EventGroup group) const;

    /// The number of events of a kind as text, e.g. "984 joint slips"; empty if there were none.
    std::string kindText(EventKind kind) const;

    /// The number of events of each kind in a group as text, e.g. "984 joint slips, 208 joint openings"; empty if there
    /// were none.
    std::string kindsText(EventGroup group) const;

    /// The number of events of each group and kind as text, e.g. "1192 slip (984 joint slips, 208 joint openings), 56
    /// debondings"; empty if there were no events.
    std::string text() const;

    bool operator==(const EventCounts&) const = default;

private:
    std::array<long, eventKinds.size()> counts_{};
};

}  // namespace keyblock
