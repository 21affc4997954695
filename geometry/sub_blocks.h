// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cuts a polygon into cells of about equal size and finds where cells share an
// edge. The grid lies along the longest edge and fits the outline's box in whole
// cells, so a rectangle falls into equal ones; what is left of cells at slanted
// or concave sides joins a neighbour where it would be a sliver.
#pragma once

#include "geometry/point.h"

#include <span>
#include <vector>

namespace keyblock {

/// Cells smaller than this share of a grid cell join a neighbour.
inline constexpr double leastCellShare = 0.25;

/// A straight piece of edge that two cells share; it runs with cell `a` on its left.
struct SharedEdge {
    int a = -1, b = -1;  // a < b
    Point from{0.0, 0.0}, to{0.0, 0.0};  // [m]
};

struct SubBlocks {
    std::vector<std::vector<Point>> cells;  // counter-clockwise, column by column along the longest edge
    std::vector<SharedEdge> shared;  // sorted by a, then b
    double cellArea = 0.0;  // of a whole grid cell [m²]
};

/// How many grid cells of about `size` [m] the outline's box holds: the cells are at most that many.
double gridCells(std::span<const Point> polygon, double size);

/// Cells of about `size` [m]. Where the corners begin and which way they run does not matter, but for round-off.
/// `tolerance` [m] decides what lies on a line of the grid.
/// \pre the polygon does not cross itself and has an area; size > 0.
SubBlocks cutIntoCells(std::span<const Point> polygon, double size, double tolerance);

}  // namespace keyblock
