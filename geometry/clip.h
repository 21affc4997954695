// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clips a straight line to a closed polygon, such as a joint trace to its region. The
// computed crossings with an edge do not depend on the length of the requested piece
// of the line, so that enlarging a region does not change what lies in the smaller one.
#pragma once

#include "geometry/point.h"

#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// A straight line segment.
struct Segment {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]

    bool operator==(const Segment&) const = default;
};

/// The parts of the line place + s·along, with begin <= s <= end, that lie in the closed polygon. Each part is an
/// interval of s [m]; the intervals are in increasing order. If the line is inside the polygon at s = `begin`, the
/// first interval starts exactly at `begin`; likewise, the last one ends exactly at `end`. Parts within the tolerance
/// of an edge count as inside; parts no longer than the tolerance are omitted.
/// \param polygon clockwise or counter-clockwise; may be concave
/// \param along unit vector
/// \param tolerance [m]
/// \pre the polygon does not cross itself.
std::vector<std::pair<double, double>> clipped(std::span<const Point> polygon, const Point& place, const Point& along,
                                               double begin, double end, double tolerance);

}  // namespace keyblock
