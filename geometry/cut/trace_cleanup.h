// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prepares traces for the cut. In exact arithmetic every near miss would remain a gap
// and every near coincidence a sliver, so both are closed beforehand, within a tolerance
// and in double precision:
//   1. Ends that are close to each other, or to a corner of the boundary, are merged.
//   2. Of traces that coincide, the one with the lower source is kept, and of the other
//      only the parts that extend beyond it.
//   3. An end that nearly or just reaches a trace or the boundary is extended slightly
//      beyond it. The excess bounds no face and is removed after the cut.
// Traces therefore stay straight, and no crossing depends on a rounded point.
#pragma once

#include "geometry/cut/cut.h"
#include "geometry/cut/planar_map.h"
#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace keyblock {

/// A boundary edge, or a part of a trace that remains after the clean-up.
struct TracePiece {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    int source = borderSource;
    double addedBefore = 0.0, addedBehind = 0.0;  // lengths by which the ends were extended [m]
    bool bridge = false;  // added link from an end to a trace or boundary that it nearly reaches
};

struct CleanTraces {
    std::vector<TracePiece> pieces;
    std::vector<MarkedSegment> segments;  // one per piece; owner: index of the piece; domains: index of the domain
    std::vector<CutNote> notes;
};

/// Prepares traces for the cut as described above; the edges of the domains are not changed.
/// \param box bounding box of all domains
/// \param tolerance [m], well above the round-off of coordinates
/// \pre coordinates are finite; outlines have no repeated corners.
CleanTraces cleanTraces(std::span<const CutDomain> domains, std::vector<CutTrace> traces, const Box& box,
                        double tolerance);

}  // namespace keyblock
