// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the bolts of a pattern: at equal spacing along the wall of a tunnel and
// at a constant angle to it (theory, "Bolt patterns").
#pragma once

#include "geometry/shape/shape_problem.h"
#include "geometry/shape/tunnel_profile.h"

#include <optional>
#include <vector>

namespace keyblock {

/// A row of bolts along the wall of a tunnel, from the point of the wall nearest to `from` to the point nearest to
/// `to`; all round the tunnel if these two points coincide.
struct BoltPattern {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    Way way = Way::CounterClockwise;
    double spacing = 1.0;  // distance between heads along the true wall [m]
    double offset = 0.0;  // distance of the first head from the start of the pattern [m]
    double length = 1.0;  // of each bolt [m]
    double angleFromWall = 90.0;  // [°], between the bolt and the wall's tangent in the direction of `way`
};

/// Permitted range of the angle between bolt and wall [°]. A bolt at a smaller angle to the wall could re-enter the
/// opening where an arc is represented by a polygon, whose edges deviate from the tangent of the arc by up to 5.7°.
inline constexpr double leastAngleFromWall = 10.0, greatestAngleFromWall = 170.0;

/// The first problem that makes the pattern invalid; none if it is valid. NaN and infinity are reported as problems.
std::optional<ShapeProblem> boltPatternProblem(const BoltPattern& pattern);

struct PatternBolt {
    Point head{0.0, 0.0};  // on the polygon that represents the wall [m]
    Point farEnd{0.0, 0.0};  // at a distance of `length` from the head, in the rock [m]
    double fromBeginning = 0.0;  // distance of the head from the start of the pattern along the true wall [m]
};

/// Number of bolts that `layOut` would return. Check this number before calling `layOut`.
/// \pre boltPatternProblem(pattern) is none.
double boltCount(const TunnelProfile& profile, const BoltPattern& pattern);

/// The bolts, in order along the wall in the direction `way`. A bolt whose head lies at the end of the pattern, to
/// within 1e-9 of the length of the whole wall, is included. In a pattern all round the tunnel, no other head coincides
/// with the first. Empty if the offset is longer than the pattern.
/// \pre boltPatternProblem(pattern) is none, and boltCount(profile, pattern) is small enough to generate that many
/// bolts.
std::vector<PatternBolt> layOut(const TunnelProfile& profile, const BoltPattern& pattern);

}  // namespace keyblock
