// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Voronoi cells of about equal size that fill a region, for rock without joint sets or
// for the grains of a rock. One random site is placed in each square of a grid. The sites
// are then moved several times to the centroids of their clipped cells (Lloyd 1982),
// which makes the cells more uniform and leaves no slivers along the boundary (theory,
// "Voronoi cells").
#pragma once

#include "geometry/clip.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keyblock {

struct VoronoiCells {
    std::vector<std::vector<Point>> cells;  // corners, counter-clockwise [m]; the cells fill the region
    std::vector<Point> sites;  // per cell: its site, the nearest one for all points of the cell [m]
    std::vector<Segment> edges;  // edges common to two cells, each once; the ends are exactly corners of cells
};

/// Number of times the sites are moved to the centroids of their cells.
inline constexpr int voronoiMoves = 4;

/// Number of squares with side `size` [m] in the bounding box of the region. Check this number before calling
/// `voronoiCells`, which generates a site in each square and discards the sites outside the region.
/// \pre the region has at least one corner; size > 0.
double voronoiEstimate(std::span<const Point> region, double size);

/// Voronoi cells with a mean area of about size² [m²]. If the region is translated, the same seed gives the same cells
/// at the new position. Cells are convex except at re-entrant corners of the region. A cell interrupted by a concave
/// part of the outline is split into several cells with the same site. If no random site lies in the region, a single
/// site is placed at the centroid of the region. Edges and parts of cells that are no larger than the tolerance are
/// omitted.
/// \param region clockwise or counter-clockwise
/// \param size [m], well above the tolerance
/// \param tolerance [m], above round-off
/// \pre the region does not cross itself, and its area is not zero; voronoiEstimate(region, size) is small enough to
/// generate that many sites.
VoronoiCells voronoiCells(std::span<const Point> region, double size, std::uint64_t seed, double tolerance);

}  // namespace keyblock
