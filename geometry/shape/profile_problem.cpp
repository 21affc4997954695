// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks whether the numbers of a shape give a valid tunnel. The limits are derived in the header. Conditions are
// written so that NaN fails them.
#include "geometry/polygon.h"
#include "geometry/shape/tunnel_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace keyblock {
namespace {

using Result = std::optional<ShapeProblem>;

constexpr std::size_t mostProfilePoints = 10'000;

bool isPositive(double length) { return length > 0.0 && std::isfinite(length); }

Result lengthProblem(double length, const char* field) {
    if (isPositive(length)) return std::nullopt;
    return ShapeProblem{field, std::string("the ") + field + " of a tunnel must be above 0", "give metres"};
}

Result centerProblem(const Point& center) {
    if (center.allFinite()) return std::nullopt;
    return ShapeProblem{"center", "the centre of the tunnel is not a finite point", "give the centre of its bounding box"};
}

Result boxProblem(const Point& center, double width, double height) {
    if (auto problem = centerProblem(center)) return problem;
    if (auto problem = lengthProblem(width, "width")) return problem;
    if (auto problem = lengthProblem(height, "height")) return problem;
    if (height >= 0.5 * width) return std::nullopt;
    return ShapeProblem{"height", "the height is less than half the width, which is the height of the round crown",
                        "increase the height, or use the profile arched with a small rise"};
}

Result problemOf(const CircleShape& s) {
    if (auto problem = centerProblem(s.center)) return problem;
    return lengthProblem(s.diameter, "diameter");
}

Result problemOf(const DShape& s) { return boxProblem(s.center, s.width, s.height); }

Result problemOf(const HorseshoeShape& s) {
    if (auto problem = boxProblem(s.center, s.width, s.height)) return problem;
    // A height 0.1 % below the one at which the walls meet still leaves a floor.
    const double highest = 0.5 * (1.0 + std::numbers::sqrt3) * s.width;
    if (s.height <= 0.999 * highest) return std::nullopt;
    return ShapeProblem{"height",
                        "at this height the walls, whose radius is the width, leave no floor: the height must be less "
                        "than 1.364 times the width",
                        "reduce the height or widen the tunnel"};
}

Result problemOf(const ArchedShape& s) {
    if (auto problem = centerProblem(s.center)) return problem;
    if (auto problem = lengthProblem(s.width, "width")) return problem;
    if (!(s.wallHeight >= 0.0 && std::isfinite(s.wallHeight)))
        return ShapeProblem{"wall_height", "the height of the walls must not be negative", "give metres, or 0"};
    if (!isPositive(s.rise))
        return ShapeProblem{"rise", "the rise of the arch must be above 0",
                            "give metres; for a flat roof use the profile polygon"};
    if (s.rise < flattestArch * s.width)
        return ShapeProblem{"rise", "the rise of the arch is less than a thousandth of the width",
                            "increase it; for a flat roof use the profile polygon"};
    if (s.rise <= 0.5 * s.width) return std::nullopt;
    return ShapeProblem{"rise", "the rise is more than half the width: the arch would bulge beyond its walls",
                        "reduce the rise, or use the profile circle"};
}

Result problemOf(const PolygonShape& s) {
    const auto problem = [](const char* message, const char* remedy) {
        return ShapeProblem{"points", message, remedy};
    };
    if (s.points.size() < 3) return problem("an outline needs three points or more", "add points");
    if (s.points.size() > mostProfilePoints)
        return problem("an outline has at most 10000 points", "omit points that hardly change it");
    if (!std::all_of(s.points.begin(), s.points.end(), [](const Point& p) { return p.allFinite(); }))
        return problem("a point of the outline is not finite", "give finite coordinates");
    const Box box = boxOf(s.points);
    const double size = (box.max - box.min).norm();
    if (crossesItself(s.points, 1e-9 * size))
        return problem("the outline crosses itself", "give the points in order around the outline");
    if (!(std::abs(signedArea(s.points)) > 1e-9 * size * size))
        return problem("the outline has no area", "move the points apart");
    return std::nullopt;
}

}  // namespace

std::optional<ShapeProblem> profileProblem(const ProfileShape& shape) {
    return std::visit([](const auto& s) { return problemOf(s); }, shape);
}

}  // namespace keyblock
