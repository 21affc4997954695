// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The outlines of tunnels. A profile is stored as its straight segments and arcs. Blocks
// are cut along a polygon with its corners on these, but bolts are positioned by length
// along the true wall and normal to it (theory, "Tunnel profiles").
//
// With width w and height h:
//
//   circle     Diameter d.
//   d-shape    Vertical walls of height h − w/2 under a semicircle.
//   horseshoe  The crown is a semicircle of radius w/2 with its springing line at the height H = h − w/2 above the
//              floor. Below it each wall is an arc of radius w, tangent to the crown, with its centre at the opposite
//              end of the springing line. At a depth y below that line the half-width is √(w² − y²) − w/2. The floor
//              is 2√(w² − H²) − w wide, which is positive for H < w√3/2, so w/2 <= h < w(1 + √3)/2 ≈ 1.366 w.
//   arched     Vertical walls under a circular arc of rise r over the chord w: radius (w²/4 + r²)/(2r), half-angle
//              2·atan(2r/w). For r > w/2 the arc is wider than the chord.
//
// Pieces of zero length (the walls of a d-shape with h = w/2) are omitted.
#pragma once

#include "geometry/point.h"
#include "geometry/shape/shape_problem.h"

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
    std::vector<Point> points;  // corners [m], clockwise or counter-clockwise
};
using ProfileShape = std::variant<CircleShape, DShape, HorseshoeShape, ArchedShape, PolygonShape>;

/// Smallest ratio of rise to width of an arch. The centre of a flatter arch would be so far away that points on its
/// wall would lose accuracy.
inline constexpr double flattestArch = 1e-3;

/// The first problem that makes the shape invalid; none if it is valid. NaN and infinity are reported as problems.
std::optional<ShapeProblem> profileProblem(const ProfileShape& shape);

/// Circular arc in counter-clockwise direction.
struct Arc {
    Point center{0.0, 0.0};  // [m]
    double radius = 0.0;  // [m]
    double start = 0.0, sweep = 0.0;  // start angle from +x, and angle of the arc, > 0 [°]
};

/// A straight segment or an arc of the wall, with the opening on the left.
struct ProfilePiece {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
    std::optional<Arc> arc;  // none: straight
    int edges = 1;  // number of polygon edges that represent it
    double begin = 0.0, length = 0.0;  // position and length along the wall [m]
};

/// The wall, counter-clockwise from its start, which is the bottom of a circle, the first point of a polygon, or the
/// left end of the floor for all other shapes.
struct TunnelProfile {
    std::vector<ProfilePiece> pieces;
    double length = 0.0;  // total length of the true wall [m]
};

/// Minimum and maximum number of polygon edges that represent a full circle, regardless of the requested sagitta.
inline constexpr int leastEdgesOfCircle = 32;
inline constexpr int mostEdgesOfCircle = 4096;

/// Profile of a tunnel shape. Arcs are represented by an even number of equal edges, so that the middle of a crown is a
/// corner.
/// \param sagitta [m] largest distance between an edge and its arc; none: `leastEdgesOfCircle` edges per circle, which
/// gives a sagitta of 0.5 % of the radius
/// \pre profileProblem(shape) is none; sagitta > 0.
TunnelProfile tunnelProfile(const ProfileShape& shape, std::optional<double> sagitta = std::nullopt);

/// Corner `i` of the polygon edges that represent a piece: 0 is the start of the piece, `edges` its end.
Point cornerOf(const ProfilePiece& piece, int i);

/// The polygon that represents the wall, counter-clockwise, with its corners on the true wall.
std::vector<Point> outline(const TunnelProfile& profile);

// Positions are lengths [m] along the true wall, counter-clockwise from the start, modulo the length of the whole wall.

/// Point at a position on the true wall.
Point pointAtLength(const TunnelProfile& profile, double length);

/// Point at a position on the polygon that represents the wall. On an arc, it lies on the line from the arc's centre to
/// the point on the true wall.
Point outlinePointAtLength(const TunnelProfile& profile, double length);

/// Unit normal of the true wall at a position, pointing into the rock. At a corner of the true wall, it bisects the
/// angle between the normals of the two sides; a position within 1e-9 of the length of the whole wall from a corner
/// counts as the corner.
Point normalAtLength(const TunnelProfile& profile, double length);

/// Position of the point on the true wall nearest to `p`: at least 0 and less than the length of the whole wall. If
/// several points are equally near, the one with the lowest position is returned.
double lengthOfNearest(const TunnelProfile& profile, const Point& p);

/// Direction along the wall in the drawn section (x to the right, y upward).
enum class Way { CounterClockwise, Clockwise };

/// Length [m] along the wall from one position to another in the direction `way`, always less than the length of the
/// whole wall; 0 if the positions coincide to within 1e-9 of that length.
double lengthBetween(const TunnelProfile& profile, double from, double to, Way way);

}  // namespace keyblock
