// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions of the bolts of a pattern: at equal spacing along the wall of a tunnel,
// each at one angle from it (theory, "Bolt patterns").
#pragma once

#include "geometry/shape_problem.h"
#include "geometry/tunnel_profile.h"

#include <optional>
#include <vector>

namespace keyblock {

/// Bolts from the place of the wall nearest to `from` up to the one nearest to `to`; where both are one place, all
/// the way round.
struct BoltPattern {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    Way way = Way::CounterClockwise;
    double spacing = 1.0;  // between heads, along the true wall [m]
    double offset = 0.0;  // of the first head from the beginning [m]
    double length = 1.0;  // of a bolt [m]
    double angleFromWall = 90.0;  // [°], between the bolt and the wall's tangent in the direction of `way`
};

/// Between these angles from the wall [°] a bolt leaves the polygon that represents an arc, whose edges turn by up to
/// 5.7° from it.
inline constexpr double leastAngleFromWall = 10.0, greatestAngleFromWall = 170.0;

/// What keeps `pattern` from being laid out; none when nothing does. Bears NaN and infinity.
std::optional<ShapeProblem> boltPatternProblem(const BoltPattern& pattern);

struct PatternBolt {
    Point head{0.0, 0.0};  // on the polygon that represents the wall [m]
    Point farEnd{0.0, 0.0};  // `length` away, in the rock behind the wall [m]
    double fromBeginning = 0.0;  // along the true wall [m]
};

/// How many bolts `layOut` gives; for a check before it. \pre boltPatternProblem(pattern) is none.
double boltCount(const TunnelProfile& profile, const BoltPattern& pattern);

/// The bolts, in the order of `way`; a head on the end counts, within 1e-9 of the whole wall's length, but on a full
/// round none lies where the first does. None where the offset reaches beyond the end.
/// \pre boltPatternProblem(pattern) is none, boltCount is within reason.
std::vector<PatternBolt> layOut(const TunnelProfile& profile, const BoltPattern& pattern);

}  // namespace keyblock
