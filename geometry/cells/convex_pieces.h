// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides concave polygons into convex pieces, for programs that draw polygons as
// triangle fans and would paint beyond the outline of a concave polygon.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// Divides a polygon into convex pieces. Each piece is a list of corner indices of the polygon, in counter-clockwise
/// order. A convex polygon gives one piece, any other polygon gives triangles. A corner that turns right by less than
/// 1e-9 counts as straight. A polygon that crosses itself gives as many triangles as one that does not, but the
/// triangles do not tile it.
/// \pre the polygon runs counter-clockwise and has at least three corners.
std::vector<std::vector<int>> convexPieces(std::span<const Point> polygon);

}  // namespace keyblock
