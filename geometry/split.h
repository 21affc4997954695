// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parting a polygon by a straight line. Concave outlines fall into several
// pieces; no piece is joined to another by a seam of no width.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// The pieces of a polygon on both sides of a line.
struct Split {
    std::vector<std::vector<Point>> left, right;  // counter-clockwise
};

/// Parts a polygon by the line through `place` along the unit vector `along`. Corners within `tolerance` [m] of the
/// line count as on it and stay where they are; the new corners lie on it.
/// \pre counter-clockwise, and it does not cross itself.
Split split(std::span<const Point> polygon, const Point& place, const Point& along, double tolerance);

}  // namespace keyblock
