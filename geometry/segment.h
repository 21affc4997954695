// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight pieces of line: where a point falls on one, how far away it is, where
// two meet, and which parts of one lie inside a polygon (a bolt in its blocks).
#pragma once

#include "geometry/point.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// Parameter of the foot of `p` on the line a→b: 0 at a, 1 at b, beyond them outside; 0 when a = b.
double footParameter(const Point& a, const Point& b, const Point& p);

/// Distance of `p` from the segment a–b [m]; from a when a = b.
double distanceToSegment(const Point& a, const Point& b, const Point& p);

/// Where two segments meet: the parameter on each, and the place.
struct Crossing {
    double onFirst = 0.0;
    double onSecond = 0.0;
    Point place{0.0, 0.0};  // [m]
};

/// The common point of the closed segments a–b and c–d; none when they miss each other or are parallel.
std::optional<Crossing> crossing(const Point& a, const Point& b, const Point& c, const Point& d);

/// The parts of a→b inside a polygon, as parameter intervals in rising order.
/// A part along an edge, within `tolerance` [m] of it, is not inside; parts shorter than `tolerance` are left out.
/// \pre the polygon does not cross itself; either direction, concave too.
std::vector<std::pair<double, double>> insideIntervals(std::span<const Point> polygon, const Point& a, const Point& b,
                                                       double tolerance);

}  // namespace keyblock
