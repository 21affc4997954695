// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Voronoi cells of sites in the plane, within a bounding box. A corner where three
// cells meet is always computed from their sites in the same order, so that all three
// cells have identical coordinates. Corners that coincide within the tolerance, such as
// those of four sites on a circle, are merged.
#pragma once

#include "geometry/point_set.h"
#include "geometry/polygon.h"

#include <span>
#include <vector>

namespace keyblock {

struct SiteCells {
    PointSet corners;
    std::vector<std::vector<int>> rings;  // per site: corners of its cell, counter-clockwise
};

/// The Voronoi cells of `sites` within `bounds`. The run time is proportional to the number of sites if they are
/// evenly distributed.
/// \param spacing [m] approximate distance between neighbouring sites; affects only the speed
/// \param tolerance [m] distance up to which corners are merged
/// \pre sites are farther apart than the tolerance and lie in `bounds`; tolerance exceeds round-off; spacing > 0.
SiteCells siteCells(std::span<const Point> sites, const Box& bounds, double spacing, double tolerance);

}  // namespace keyblock
