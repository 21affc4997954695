// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits a polygon by a straight line. Each side of a concave polygon can give several
// pieces, which are separate and not connected by edges of zero width.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// The pieces of a polygon on the two sides of a line.
struct Split {
    std::vector<std::vector<Point>> left, right;  // counter-clockwise
};

/// Splits a polygon by a line; new corners lie on the line.
/// \param place point on the line [m]
/// \param along unit vector in the direction of the line
/// \param tolerance [m] distance up to which an existing corner counts as lying on the line; such corners are not
/// moved
/// \pre the polygon runs counter-clockwise and does not cross itself.
Split split(std::span<const Point> polygon, const Point& place, const Point& along, double tolerance);

}  // namespace keyblock
