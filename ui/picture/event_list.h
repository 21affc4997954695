// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The events that a picture numbers: what let go on bolts and which blocks fell,
// those alike on one bolt as one entry. Joints slip and open by the hundred; they
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
    double time = 0.0;  // of the first
    double lastTime = 0.0;
    int count = 1;  // of events alike
    int bolt = -1;
    int block = -1;
    int node = -1, element = -1;  // of the first
    Point place{0.0, 0.0};  // of the first [m]
    double force = 0.0;  // that the bolt held just before [N]: largest |N| of them, of a shear rupture |Q|
    std::string subject;  // bolt or block
    std::string what;  // "16 nodes debond"
    std::string when;  // "0.212 s", of a static stage its pseudo-time
};

struct EventList {
    std::vector<EventEntry> entries;
    int leftOut = 0;  // entries beyond the most that were asked for, the least grave first
    std::string counted;  // what is not listed: "690 joints slip, 121 open"; empty: none
};

/// Whether what holds the rock is lost by it, or rock comes down: what a picture must tell in words.
bool isGrave(EventKind kind);

/// The run's events until a frame, itself included. \pre in order of time.
std::vector<Event> eventsUntil(std::vector<Event> events, const FrameHead& frame);

/// At most `most` entries of these events.
EventList eventList(const RunSource& run, std::span<const Event> events, std::size_t most);

}  // namespace keyblock
