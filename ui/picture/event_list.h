// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events numbered in a picture: failures of bolts and falls of blocks, with one
// entry for several of a kind on one bolt. Joints slip and open by the hundred; they
// are counted, not numbered.
#pragma once

#include "solver/results/run_source.h"

#include <span>
#include <string>
#include <vector>

namespace keyblock {

struct EventEntry {
    int number = 0;  // from 1, in order of time
    EventKind kind = EventKind::Debonding;
    int stage = 0;
    double time = 0.0;  // of the first event
    double lastTime = 0.0;
    int count = 1;  // number of events of this kind
    int bolt = -1;
    int block = -1;
    int node = -1, element = -1;  // of the first
    Point place{0.0, 0.0};  // of the first [m]
    double force = 0.0;  // before the failure [N]: largest |N| of them, of a shear rupture |Q|
    std::string subject;  // bolt or block
    std::string what;  // "16 nodes debond"
    std::string when;  // "0.212 s", for a static stage its pseudo-time
};

struct EventList {
    std::vector<EventEntry> entries;
    int leftOut = 0;  // entries beyond the maximum, least severe first
    std::string counted;  // events not listed: "690 joint slips, 121 joint openings"; empty: none
};

/// The run's events up to and including a frame. \pre in order of time.
std::vector<Event> eventsUntil(std::vector<Event> events, const FrameHead& frame);

/// At most `most` entries of these events.
EventList eventList(const RunSource& run, std::span<const Event> events, std::size_t most);

}  // namespace keyblock
