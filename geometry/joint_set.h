// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The traces of a joint set in a region. Parallel lines carry traces with bridges
// of rock between them, as in the joint sets of UDEC: a mean and a deviation each
// for dip, spacing, length and bridge, and one trace through a given origin.
//
// Lines are numbered from the origin outward in both directions, the traces of a
// line from its middle outward, and each draws from a stream of its own. A larger
// region therefore adds traces and changes none (theory, "Joint sets").
#pragma once

#include "geometry/clip.h"
#include "geometry/random.h"
#include "geometry/shape_problem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// The line with number n lies off the origin by the sum of n spacings, to the left of the dip's direction for n > 0.
/// The trace with number 0 of line 0 has its middle at the origin; so have traces that run through, abreast of it on
/// their lines, and where their dips scatter they fan out from there: the origin belongs in the region or near it.
struct JointSet {
    double dip = 0.0;  // [°], counter-clockwise from +x
    double dipDeviation = 0.0;  // standard deviation [°], normal, cut at `scatterCut`; a trace turns about its middle
    Scatter spacing{1.0, 0.0};  // between lines, normal to them
    std::optional<Scatter> length;  // of a trace; none: right through the region, and no bridges
    Scatter bridge;  // rock between two traces of a line
    /// By which share of length + bridge (means) each line is set on against the last: 0 side by side, 0.5 as bricks
    /// are laid; none: at random, line by line.
    std::optional<double> stagger = 0.0;
    Point origin{0.0, 0.0};  // [m]
    std::uint64_t seed = 1;
};

/// Limits of a joint set, checked by `jointSetProblem`.
inline constexpr double largestDipDeviation = 25.0;  // [°]; three of them stay below a right angle
inline constexpr double largestDeviationRatio = 2.0;  // deviation over mean

/// What keeps `set` from being drawn; none when nothing does. Bears NaN and infinity.
std::optional<ShapeProblem> jointSetProblem(const JointSet& set);

/// About how many lines and traces have to be numbered to fill the box of `region`: those in it, and where numbers are
/// random also those between it and the origin. A trace can give several pieces in a concave region.
/// \pre jointSetProblem(set) is none, the region has a corner.
double jointTraceEstimate(const JointSet& set, std::span<const Point> region);

struct JointTrace {
    Segment segment;  // from end to end along the dip
    std::int64_t line = 0;
    std::int64_t number = 0;  // on its line; 0 of a line that runs through
};

/// The traces, clipped to the closed region, by line, number and place along the dip. A trace that a concave region
/// interrupts continues behind it on the same line. `tolerance` [m] as in `clipped`.
/// \pre jointSetProblem(set) is none; the region does not cross itself; jointTraceEstimate is within reason.
std::vector<JointTrace> jointTraces(const JointSet& set, std::span<const Point> region, double tolerance);

}  // namespace keyblock
