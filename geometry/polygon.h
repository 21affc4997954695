// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons as lists of corners, the first not repeated at the end. Areas and
// moments are exact integrals taken about a corner, so that a scene a thousand
// kilometres from the origin keeps its digits.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <vector>

namespace keyblock {

/// Area, centroid and second moments about the centroid; the same for either direction.
struct Moments {
    double area = 0.0;  // [m²]
    Point centroid{0.0, 0.0};  // [m]
    double sxx = 0.0;  // ∫x² dA [m⁴]
    double syy = 0.0;  // ∫y² dA [m⁴]
    double sxy = 0.0;  // ∫xy dA [m⁴]
};

/// Area, positive when the corners run counter-clockwise [m²].
double signedArea(std::span<const Point> polygon);

/// Exact moments; of a polygon without area, zeros about its first corner.
/// \pre at least one corner.
Moments moments(std::span<const Point> polygon);

/// The same corners, counter-clockwise; the first stays first.
std::vector<Point> counterClockwise(std::vector<Point> polygon);

/// Least distance of `p` from the edges, inside or outside [m].
/// \pre at least one corner.
double distanceToBoundary(std::span<const Point> polygon, const Point& p);

enum class Side { Outside, Boundary, Inside };

/// Where `p` lies; `Boundary` within `tolerance` [m] of an edge. Concave polygons and either direction are fine.
Side locate(std::span<const Point> polygon, const Point& p, double tolerance);

/// A place where the outline crosses itself or runs back along itself; none for a sound outline.
/// Repeated corners are skipped, and touching itself in a point without crossing is allowed.
/// `tolerance` [m] decides what touches.
std::optional<Point> crossesItself(std::span<const Point> polygon, double tolerance);

/// True when the interiors of two polygons share more than a seam of depth `tolerance` [m].
/// \pre neither crosses itself.
bool overlap(std::span<const Point> a, std::span<const Point> b, double tolerance);

/// True when `inner` lies within `outer` from end to end, but for a seam of depth `tolerance` [m].
/// \pre neither crosses itself.
bool contains(std::span<const Point> outer, std::span<const Point> inner, double tolerance);

/// Upright rectangle.
struct Box {
    Point min{0.0, 0.0};  // [m]
    Point max{0.0, 0.0};  // [m]
};

/// The smallest box around points. \pre at least one point.
Box boxOf(std::span<const Point> points);

/// The box with `margin` [m] added on every side.
Box grown(const Box& box, double margin);

/// True when two closed boxes share a point.
bool meets(const Box& a, const Box& b);

}  // namespace keyblock
