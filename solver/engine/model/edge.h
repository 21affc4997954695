// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An edge of a block as lines and normals, for whatever acts on it or touches it.
#pragma once

#include "geometry/point.h"

#include <vector>

namespace keyblock {

/// An edge of a block: start, unit direction, outward normal, length [m].
struct Edge {
    Point start{0.0, 0.0}, along{1.0, 0.0}, outward{0.0, -1.0};
    double length = 0.0;
};

/// Edge `index` of an outline, from corner `index` to the next. \param corners counter-clockwise [m]
Edge edgeOf(const std::vector<Point>& corners, int index);

}  // namespace keyblock
