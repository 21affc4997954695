// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes traces fit to be cut with. Exact arithmetic would keep every near-miss as
// a gap and every near-coincidence as a sliver, so both are closed before, within
// a tolerance and in plain doubles:
//   1. ends that are close to each other, or to a corner of the border, become one;
//   2. of traces that run along each other the one of the lower source stays, and
//      of the other what goes beyond it;
//   3. an end that nearly reaches a trace or the border, or just reaches it, is
//      pulled over it. What extends beyond bounds no face and is dropped afterwards.
// So no trace is ever bent, and no crossing depends on a rounded place.
#pragma once

#include "geometry/cut.h"
#include "geometry/planar_map.h"
#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace keyblock {

/// An edge of the border, or what is left of a trace.
struct TracePiece {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    int source = borderSource;
    double addedBefore = 0.0, addedBehind = 0.0;  // by pulling the ends over [m]
    bool bridge = false;  // from an end to what it nearly reaches; no part of a trace
};

struct CleanTraces {
    std::vector<TracePiece> pieces;
    std::vector<MarkedSegment> segments;  // the same pieces; owner: the piece, domain: the index of the domain
    std::vector<CutNote> notes;
};

/// Cleans traces for domains in the order given; edges of domains stay as they are.
/// \pre finite; outlines without repeated corners; `tolerance` well above the round-off of coordinates.
CleanTraces cleanTraces(std::span<const CutDomain> domains, std::vector<CutTrace> traces, const Box& box,
                        double tolerance);

}  // namespace keyblock
