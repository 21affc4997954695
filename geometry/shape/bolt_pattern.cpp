// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths and normals are those of the true, curved wall. The heads are moved onto the polygon along which the blocks
// are cut, so that no head lies in the air or inside the rock.
#include "geometry/shape/bolt_pattern.h"

#include "geometry/angle.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {
namespace {

/// Fraction of the whole length below which two positions coincide.
constexpr double together = 1e-9;

/// Largest distance of a bolt head from the start of the pattern [m]; less than the offset if there is no room for a
/// bolt.
double lastPlace(const TunnelProfile& profile, const BoltPattern& pattern) {
    const double from = lengthOfNearest(profile, pattern.from);
    const double to = lengthOfNearest(profile, pattern.to);
    const double part = lengthBetween(profile, from, to, pattern.way);
    const double margin = together * profile.length;
    if (part > 0.0) return part + margin;
    return std::min(profile.length + margin, pattern.offset + profile.length - margin);
}

}  // namespace

std::optional<ShapeProblem> boltPatternProblem(const BoltPattern& pattern) {
    if (!pattern.from.allFinite())
        return ShapeProblem{"from", "the start is not a finite point", "give a point on the wall"};
    if (!pattern.to.allFinite())
        return ShapeProblem{"to", "the end is not a finite point", "give a point on the wall"};
    if (!(pattern.spacing > 0.0 && std::isfinite(pattern.spacing)))
        return ShapeProblem{"spacing", "the spacing of bolts must be above 0", "give metres along the wall"};
    if (!(pattern.offset >= 0.0 && std::isfinite(pattern.offset)))
        return ShapeProblem{"offset", "the offset must not be negative", "start the pattern farther back"};
    if (!(pattern.length > 0.0 && std::isfinite(pattern.length)))
        return ShapeProblem{"length", "the length of a bolt must be above 0", "give metres"};
    if (!(pattern.angleFromWall >= leastAngleFromWall && pattern.angleFromWall <= greatestAngleFromWall))
        return ShapeProblem{"angle_from_wall", "the angle from the wall must lie between 10 and 170 degrees",
                            "90 is normal to the wall; a smaller angle inclines bolts forward along the pattern"};
    return std::nullopt;
}

double boltCount(const TunnelProfile& profile, const BoltPattern& pattern) {
    assert(!boltPatternProblem(pattern));
    const double room = lastPlace(profile, pattern) - pattern.offset;
    return room < 0.0 ? 0.0 : std::floor(room / pattern.spacing) + 1.0;
}

std::vector<PatternBolt> layOut(const TunnelProfile& profile, const BoltPattern& pattern) {
    assert(!boltPatternProblem(pattern));
    const double sense = pattern.way == Way::CounterClockwise ? 1.0 : -1.0;
    const double beginning = lengthOfNearest(profile, pattern.from);
    const Point lean = directionOf(pattern.angleFromWall);
    const auto count = static_cast<std::size_t>(boltCount(profile, pattern));
    std::vector<PatternBolt> bolts(count);
    for (std::size_t i = 0; i < count; ++i) {
        PatternBolt& bolt = bolts[i];
        bolt.fromBeginning = pattern.offset + static_cast<double>(i) * pattern.spacing;
        const double place = beginning + sense * bolt.fromBeginning;
        const Point normal = normalAtLength(profile, place);
        const Point onward = sense * turnLeft(normal);  // going counter-clockwise, the opening lies on the left
        bolt.head = outlinePointAtLength(profile, place);
        bolt.farEnd = bolt.head + pattern.length * (lean.x() * onward + lean.y() * normal);
    }
    return bolts;
}

}  // namespace keyblock
