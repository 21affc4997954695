// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons as lists of corners, the first not repeated at the end. Areas and moments
// are integrated exactly about a corner, so that they stay accurate even a thousand
// kilometres from the origin.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// Area, centroid and second moments of area about the centroid. The direction of the outline does not affect them.
struct Moments {
    double area = 0.0;  // [m²]
    Point centroid{0.0, 0.0};  // [m]
    double sxx = 0.0;  // ∫x² dA [m⁴]
    double syy = 0.0;  // ∫y² dA [m⁴]
    double sxy = 0.0;  // ∫xy dA [m⁴]
};

/// Area [m²], positive if the corners run counter-clockwise.
double signedArea(std::span<const Point> polygon);

/// Moments of a polygon. If its area is zero, the moments are zero and the centroid is the first corner.
/// \pre the polygon has at least one corner.
Moments moments(std::span<const Point> polygon);

/// The corners in counter-clockwise order; the first corner stays first.
std::vector<Point> counterClockwise(std::vector<Point> polygon);

/// Distance [m] from a point, inside or outside the polygon, to the nearest edge.
/// \pre the polygon has at least one corner.
double distanceToBoundary(std::span<const Point> polygon, const Point& p);

enum class Side { Outside, Boundary, Inside };

/// Position of `p` relative to a polygon, which may be concave and either clockwise or counter-clockwise.
/// \param tolerance [m] distance from an edge up to which a point counts as lying on the boundary
Side locate(std::span<const Point> polygon, const Point& p, double tolerance);

/// A point at which the outline crosses itself or runs back along itself; none if the outline is valid. Repeated
/// corners are skipped, an outline may touch itself at a point without crossing; one with a corner that is not finite is
/// not examined.
/// \param tolerance [m] distance up to which points and edges count as touching
std::optional<Point> crossesItself(std::span<const Point> polygon, double tolerance);

/// True if the interiors of two polygons overlap by more than a strip of width `tolerance` [m].
/// \pre neither polygon crosses itself.
bool overlap(std::span<const Point> a, std::span<const Point> b, double tolerance);

/// True if `inner` lies entirely in `outer`, except for a strip of width `tolerance` [m].
/// \pre neither polygon crosses itself.
bool contains(std::span<const Point> outer, std::span<const Point> inner, double tolerance);

/// Axis-aligned rectangle.
struct Box {
    Point min{0.0, 0.0};  // [m]
    Point max{0.0, 0.0};  // [m]
};

/// Bounding box of the points. \pre there is at least one point.
Box boxOf(std::span<const Point> points);

/// The box enlarged by `margin` [m] on every side.
inline Box grown(const Box& box, double margin) {
    return {box.min - Point::Constant(margin), box.max + Point::Constant(margin)};
}

/// True if the two closed boxes have a common point.
inline bool meets(const Box& a, const Box& b) {
    return a.min.x() <= b.max.x() && b.min.x() <= a.max.x() && a.min.y() <= b.max.y() && b.min.y() <= a.max.y();
}

}  // namespace keyblock
