// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Voronoi cells of about one size over a region: rock without joint sets, or the
// grains of a rock. Sites are scattered one to a square of a grid and then moved
// a few times to the centroids of their clipped cells (Lloyd 1982), which evens
// the cells out and leaves no slivers along the border (theory, "Voronoi cells").
#pragma once

#include "geometry/clip.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keyblock {

struct VoronoiCells {
    std::vector<std::vector<Point>> cells;  // counter-clockwise [m]; together they fill the region
    std::vector<Point> sites;  // of each cell: its points are nearer to it than to any other [m]
    std::vector<Segment> edges;  // that two cells share, each once; their ends are corners of cells to the last digit
};

/// How often sites move to the centroids of their cells.
inline constexpr int voronoiMoves = 4;

/// How many squares of side `size` [m] the box of the region holds: sites are scattered over all of them, and those
/// outside the region are dropped. For a check before the work.
/// \pre the region has a corner, size > 0.
double voronoiEstimate(std::span<const Point> region, double size);

/// Cells whose mean area is about size² [m²], the same for the same seed wherever the region is moved. They are convex,
/// but for corners of a concave region; a cell that a notch of the region interrupts is several, with one site. A
/// region too small for a site is one cell, of no site but its centroid. What is no larger than `tolerance` [m] is left
/// out of cells and edges.
/// \pre the region does not cross itself and has an area; either direction; size is well above the tolerance, which
/// is above round-off; voronoiEstimate is within reason.
VoronoiCells voronoiCells(std::span<const Point> region, double size, std::uint64_t seed, double tolerance);

}  // namespace keyblock
