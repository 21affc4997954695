// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of tunnels. A profile is kept as the straight pieces and arcs it is
// made of: blocks are cut along a polygon with its corners on them, but bolts are
// set by length along the true wall and normal to it (theory, "Tunnel profiles").
//
// With the middle of the bounding box at (0, 0), width w and height h:
//
//   circle     radius d/2.
//   d-shape    walls of height h − w/2 under a semicircle.
//   horseshoe  The crown is a semicircle of radius w/2. At its springing line, the level h − w/2 =: H above the floor,
//              it is vertical; a smooth wall with radius w has its centre on that level, at the foot of
//              the opposite wall of the crown. A depth y below it the half-width is √(w² − y²) − w/2, so the floor is
//              2√(w² − H²) − w wide, which is above 0 for H < w√3/2: w/2 <= h < w(1 + √3)/2 ≈ 1.366 w.
//   arched     walls under the arc of a circle with rise r over the chord w: radius (w²/4 + r²)/(2r), half-angle
//              2·atan(2r/w). It bulges over the walls for r > w/2.
//
// A piece that comes out without length (the walls of a d-shape with h = w/2) is left out.
#pragma once

#include "geometry/point.h"
#include "geometry/shape_problem.h"

#include <optional>
#include <variant>
#include <vector>

namespace keyblock {

struct CircleShape {
    Point center{0.0, 0.0};  // [m]
    double diameter = 0.0;  // [m]
};
struct DShape {
    Point center{0.0, 0.0};  // of the bounding box [m]
    double width = 0.0, height = 0.0;  // [m]
};
struct HorseshoeShape {
    Point center{0.0, 0.0};  // of the bounding box [m]
    double width = 0.0, height = 0.0;  // [m]
};
struct ArchedShape {
    Point center{0.0, 0.0};  // of the bounding box [m]
    double width = 0.0, wallHeight = 0.0, rise = 0.0;  // [m]
};
struct PolygonShape {
    std::vector<Point> points;  // in either direction [m]
};
using ProfileShape = std::variant<CircleShape, DShape, HorseshoeShape, ArchedShape, PolygonShape>;

/// Least rise over width of an arch; the centre of a flatter one lies so far away that its wall loses digits.
inline constexpr double flattestArch = 1e-3;

/// What keeps a shape from being a tunnel; none when nothing does. Bears NaN and infinity.
std::optional<ShapeProblem> profileProblem(const ProfileShape& shape);

/// Part of a circle, run counter-clockwise.
struct Arc {
    Point center{0.0, 0.0};  // [m]
    double radius = 0.0;  // [m]
    double start = 0.0, sweep = 0.0;  // [°] from +x; sweep > 0
};

/// A straight or round part of the wall, with the opening on its left.
struct ProfilePiece {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    std::optional<Arc> arc;  // none: straight
    int edges = 1;  // of the polygon that represents it
    double begin = 0.0, length = 0.0;  // along the wall [m]
};

/// The wall, counter-clockwise from its start: the bottom of a circle, the lower left corner (the left end of the chord
/// or floor) of the other shapes, the first point of a polygon.
struct TunnelProfile {
    std::vector<ProfilePiece> pieces;
    double length = 0.0;  // of the true wall [m]
};

/// Edges of the polygon that represents a full circle: at least, and at most however small the requested sagitta is.
inline constexpr int leastEdgesOfCircle = 32;
inline constexpr int mostEdgesOfCircle = 4096;

/// Arcs get an even number of equal edges, so that a crown has a corner in its middle. `sagitta` [m] is the farthest
/// that an edge may lie off its arc; none: `leastEdgesOfCircle` alone decides (0.5 % of the radius).
/// \pre profileProblem(shape) is none; sagitta > 0.
TunnelProfile tunnelProfile(const ProfileShape& shape, std::optional<double> sagitta = std::nullopt);

/// Corner `i` of the polygon's part that represents a piece: 0 its beginning, `edges` its end.
Point cornerOf(const ProfilePiece& piece, int i);

/// The polygon that represents the wall, counter-clockwise, its corners on the true wall.
std::vector<Point> outline(const TunnelProfile& profile);

// Lengths run along the true wall, counter-clockwise from the start [m]; any length is taken round and round.

/// The place on the true wall.
Point pointAtLength(const TunnelProfile& profile, double length);

/// The place on the polygon, seen from the centre of the arc in line with the place on the true wall.
Point outlinePointAtLength(const TunnelProfile& profile, double length);

/// The unit normal of the true wall, pointing into the rock; at a corner, within 1e-9 of the whole length, half-way
/// between the normals of both sides.
Point normalAtLength(const TunnelProfile& profile, double length);

/// Where the true wall is nearest to `p`, from 0 to below the whole length; of places equally near, the first.
double lengthOfNearest(const TunnelProfile& profile, const Point& p);

/// Direction along the wall, as the section is drawn (x to the right, y upward).
enum class Way { CounterClockwise, Clockwise };

/// How far it is from one place to another [m], from 0 to below the whole length; 0 when both are one place, within
/// 1e-9 of the whole length.
double lengthBetween(const TunnelProfile& profile, double from, double to, Way way);

}  // namespace keyblock
