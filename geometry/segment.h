// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight line segments: projection of a point, distance from a point, intersection,
// and the parts inside a polygon (e.g. of a bolt in a block).
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// Parameter of the projection of `p` onto the line through a and b: 0 at a, 1 at b, and less than 0 or greater than 1
/// beyond the ends. The result is 0 if a = b.
double footParameter(const Point& a, const Point& b, const Point& p);

/// Distance [m] of `p` from the segment a–b, which may have zero length.
double distanceToSegment(const Point& a, const Point& b, const Point& p);

/// Intersection of two segments: the parameter on each (0 … 1), and the point.
struct Crossing {
    double onFirst = 0.0;
    double onSecond = 0.0;
    Point place{0.0, 0.0};  // [m]
};

/// Intersection of the closed segments a–b and c–d; none if they have no common point or are parallel.
std::optional<Crossing> crossing(const Point& a, const Point& b, const Point& c, const Point& d);

/// The parts of the segment a–b inside a polygon, as parameter intervals (0 at a, 1 at b) in increasing order. Parts
/// that run along an edge, within the tolerance, do not count as inside; parts no longer than the tolerance are
/// omitted.
/// \param polygon clockwise or counter-clockwise; may be concave
/// \param tolerance [m]
/// \pre the polygon does not cross itself.
std::vector<std::pair<double, double>> insideIntervals(std::span<const Point> polygon, const Point& a, const Point& b,
                                                       double tolerance);

}  // namespace keyblock
