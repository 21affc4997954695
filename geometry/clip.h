// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which parts of a straight line lie in a polygon, its outline counted in: what a
// joint keeps of a region. Where the line crosses an edge does not depend on how
// long a piece of it is requested, so a larger region changes nothing of what
// lies in the smaller one.
#pragma once

#include "geometry/point.h"

#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// A straight piece of line.
struct Segment {
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]

    bool operator==(const Segment&) const = default;
};

/// The parts of place + s·along, begin <= s <= end, in the closed polygon, as intervals of s in rising order.
/// `along` is a unit vector; s, begin and end are in metres. An end that lies in the polygon comes back unchanged. A
/// part within `tolerance` [m] of an edge belongs to it; parts no longer than `tolerance` are left out.
/// \pre the polygon does not cross itself; either direction, concave too.
std::vector<std::pair<double, double>> clipped(std::span<const Point> polygon, const Point& place, const Point& along,
                                               double begin, double end, double tolerance);

}  // namespace keyblock
