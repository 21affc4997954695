// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which kinds of events people take as one, and how many there were: the words and
// the numbers of the window's time line, of `info` and of figures are these.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/quantity_text.h"

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

enum class EventGroup { Slip, Debonding, Restick, Yield, Rupture, Plate, PulledOut, Falls };
inline constexpr std::size_t eventGroups = 8;

/// Hinges belong to yield, an opened joint to slip, a lost bolt to rupture, a collapse to block falls.
EventGroup groupOf(EventKind kind);
std::vector<EventKind> kindsOf(EventGroup group);
std::string_view wordOf(EventGroup group);  // slip … block falls

/// Joints slip and open, and bonds stick again, by the thousand, and nothing is lost by it.
bool isMinor(EventKind kind);

class EventCounts {
public:
    EventCounts() = default;
    explicit EventCounts(std::span<const Event> events);

    void add(const Event& event) { ++counts_[static_cast<std::size_t>(event.kind)]; }
    long of(EventKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }
    long of(EventGroup group) const;

    /// "984 joint-slip, 208 joint-open": the kinds of a group that there were; empty where there were none.
    std::string kindsText(EventGroup group) const;

    /// "1192 slip (984 joint-slip, 208 joint-open), 56 debonding"; empty where there were none.
    std::string text() const;

    bool operator==(const EventCounts&) const = default;

private:
    std::array<long, eventKindWords.size()> counts_{};
};

}  // namespace keyblock
