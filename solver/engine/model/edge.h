// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Geometry of a block edge, used for loads and contacts.
#pragma once

#include "geometry/point.h"

#include <vector>

namespace keyblock {

/// An edge of a block: start, unit direction, outward normal, length [m].
struct Edge {
    Point start{0.0, 0.0}, along{1.0, 0.0}, outward{0.0, -1.0};
    double length = 0.0;
};

/// The edge from `start` to `end`, with the block on its left.
inline Edge edgeBetween(const Point& start, const Point& end) {
    const Point chord = end - start;
    const double length = chord.norm();
    const Point along = chord / length;
    return {start, along, -turnLeft(along), length};
}

/// Length of edge `index` of an outline [m].
inline double edgeLength(const std::vector<Point>& corners, int index) {
    const std::size_t start = index, next = start + 1;
    return (corners[next < corners.size() ? next : 0] - corners[start]).norm();
}

/// Edge `index` of an outline, from corner `index` to the next one.
/// \param corners the corners of the outline, counter-clockwise [m].
inline Edge edgeOf(const std::vector<Point>& corners, int index) {
    const std::size_t start = index, next = start + 1;
    return edgeBetween(corners[start], corners[next < corners.size() ? next : 0]);
}

}  // namespace keyblock
