// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Divides a polygon into cells of about equal size and finds their common edges. The
// grid is parallel to the longest edge and fills the bounding box in that direction with
// whole cells, so that a rectangle is divided into equal cells. Parts of grid cells at
// inclined or concave sides are merged with a neighbour if they would be slivers.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// Cells with an area below this fraction of the area of a grid cell are merged with a neighbour.
inline constexpr double leastCellShare = 0.25;

/// A straight part of an edge shared by two cells. Cell `a` is on the left when going from `from` to `to`.
struct SharedEdge {
    int a = -1, b = -1;  // indices of the cells; a < b
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
};

struct SubBlocks {
    std::vector<std::vector<Point>> cells;  // counter-clockwise, column by column along the longest edge
    std::vector<SharedEdge> shared;  // sorted by `a`, then `b`
    double cellArea = 0.0;  // area of a whole grid cell [m²]
};

/// Estimated number of grid cells with side `size` [m] in the bounding box of the polygon. The box is aligned with the
/// longest edge of the polygon.
double gridCells(std::span<const Point> polygon, double size);

/// Divides a polygon into cells. Apart from round-off, the result does not depend on which corner is first or on the
/// direction of the outline.
/// \param size [m] approximate cell size
/// \param tolerance [m] distance up to which a point counts as lying on a grid line
/// \pre the polygon does not cross itself, and its area is not zero; size > 0.
SubBlocks cutIntoCells(std::span<const Point> polygon, double size, double tolerance);

}  // namespace keyblock
