// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Voronoi cells of sites in the plane, bounded by a box well outside. A corner
// where three cells meet is computed from their three sites in one order, so all
// three have the same doubles; corners that fall together within the tolerance,
// as those of four sites on one circle do, are one.
#pragma once

#include "geometry/point_set.h"
#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace keyblock {

struct SiteCells {
    PointSet corners;
    std::vector<std::vector<int>> rings;  // a cell's corners, counter-clockwise; one ring for each site, in order
};

/// The cells of `sites` in `bounds`, in time proportional to their number where they are evenly spread.
/// `spacing` [m] is about the distance of neighbours and decides the speed alone.
/// \pre sites are farther apart than `tolerance` [m] and lie in `bounds`; tolerance is above round-off; spacing > 0.
SiteCells siteCells(std::span<const Point> sites, const Box& bounds, double spacing, double tolerance);

}  // namespace keyblock
