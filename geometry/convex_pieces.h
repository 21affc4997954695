// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that draw polygons as fans of triangles paint a concave one over its
// own outline. Convex pieces are handed to such programs instead.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// The convex pieces of a polygon as indices of its corners, each counter-clockwise: all corners where it is convex,
/// else triangles. A corner that turns right by less than 1e-9 counts as straight. A polygon that crosses itself gets
/// as many triangles, which then do not tile it.
/// \pre counter-clockwise, three corners or more.
std::vector<std::vector<int>> convexPieces(std::span<const Point> polygon);

}  // namespace keyblock
