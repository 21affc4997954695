// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generates the traces of a joint set in a region. The traces lie on parallel lines,
// separated by rock bridges, as in the joint sets of UDEC: dip, spacing, trace length
// and bridge each have a mean and a standard deviation, and one trace is centred at a
// given origin.
//
// Lines are numbered outward from the origin in both directions, and the traces of a
// line outward from its middle. Each has its own stream of random numbers, so a larger
// region adds traces but does not change any (theory, "Joint sets").
#pragma once

#include "geometry/clip.h"
#include "geometry/random.h"
#include "geometry/shape/shape_problem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// Parameters of a joint set. Line n is n spacings away from the origin; for n > 0 it lies to the left of the dip
/// direction. Trace 0 of line 0 is centred at the origin; a through-going trace is centred at the point on its line
/// nearest to the origin. If the dip varies, each trace is rotated about its centre. The origin should therefore lie
/// in or near the region if traces are through-going.
struct JointSet {
    double dip = 0.0;  // [°], counter-clockwise from +x
    double dipDeviation = 0.0;  // standard deviation [°] of a normal distribution truncated at `scatterCut`
    Scatter spacing{1.0, 0.0};  // distance between lines, normal to them
    std::optional<Scatter> length;  // length of a trace; none: through-going, without bridges
    Scatter bridge;  // length of rock between two traces of a line
    /// Shift of the traces along each line relative to those of the previous line, as a fraction of mean length + mean
    /// bridge. 0: traces are side by side; 0.5: traces are staggered as in a brick wall; none: the shift of each line
    /// is random.
    std::optional<double> stagger = 0.0;
    Point origin{0.0, 0.0};  // [m]
    std::uint64_t seed = 1;
};

/// Limits on the parameters of a joint set, checked by `jointSetProblem`.
inline constexpr double largestDipDeviation = 25.0;  // [°]; three standard deviations are less than a right angle
inline constexpr double largestDeviationRatio = 2.0;  // standard deviation / mean

/// The first problem that makes the joint set invalid; none if it is valid. NaN and infinity are reported as problems.
std::optional<ShapeProblem> jointSetProblem(const JointSet& set);

/// Approximate number of lines and traces that must be generated to fill the bounding box of `region`. If spacings or
/// lengths are random, lines and traces between the box and the origin are included. The number of pieces returned by
/// `jointTraces` can be higher, because a trace in a concave region can give several pieces.
/// \pre jointSetProblem(set) is none, and the region has at least one corner.
double jointTraceEstimate(const JointSet& set, std::span<const Point> region);

struct JointTrace {
    Segment segment;  // in the direction of the dip
    std::int64_t line = 0;
    std::int64_t number = 0;  // number of the trace on its line; 0 if it is through-going
};

/// The traces clipped to the closed region, sorted by line, trace number and position along the dip. A trace that is
/// interrupted by a concave part of the outline gives several pieces on the same line.
/// \param tolerance [m], as in `clipped`
/// \pre jointSetProblem(set) is none; the region does not cross itself; jointTraceEstimate(set, region) is small enough
/// to generate that many lines and traces.
std::vector<JointTrace> jointTraces(const JointSet& set, std::span<const Point> region, double tolerance);

}  // namespace keyblock
