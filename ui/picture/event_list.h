// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events that are numbered in a figure: failures of bolts and falls of blocks.
// Events of the same kind on one bolt share an entry. Joint slips and openings occur by
// the hundred, so they are counted but not numbered.
#pragma once

#include "solver/results/run_source.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct EventEntry {
    int number = 0;  // numbered from 1, in chronological order
    EventKind kind = EventKind::Debonding;
    int stage = 0;
    double time = 0.0;  // time of the first event
    double lastTime = 0.0;  // time of the last event
    int count = 1;  // number of events in this entry
    int bolt = -1;
    int block = -1;
    int node = -1, element = -1;  // of the first event
    Point place{0.0, 0.0};  // position of the first event [m]
    double force = 0.0;  // largest |N| just before these failures [N]; |Q| for a shear rupture
    std::string subject;  // name of the bolt or block
    std::string what;  // "16 nodes debond"
    std::string when;  // "0.212 s"; the pseudo-time for a static stage
};

struct EventList {
    std::vector<EventEntry> entries;
    int leftOut = 0;  // number of entries dropped to respect the maximum; the least severe are dropped first
    std::string counted;  // events not numbered: "690 joint slips, 121 joint openings"; empty: none
};

/// The events of a run up to and including a frame. \pre `events` are in chronological order.
std::vector<Event> eventsUntil(std::vector<Event> events, const FrameHead& frame);

/// The numbered list of `events`, which are events of the run `run`. The list has at most `most` entries.
EventList eventList(const RunSource& run, std::span<const Event> events, std::size_t most);

}  // namespace keyblock
