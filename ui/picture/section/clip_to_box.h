// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Clips shapes to the frame of a figure. Not every output device can clip, so parts
// outside the frame are never drawn.
#pragma once

#include "geometry/polygon.h"

#include <optional>
#include <utility>
#include <vector>

namespace keyblock {

/// The part of a polygon inside the box; empty if there is none. If the box divides a non-convex polygon into several
/// pieces, the result may connect them along the sides of the box.
std::vector<Point> clippedToBox(std::vector<Point> polygon, const Box& box);

/// The part of the segment from `a` to `b` inside the box; null if the segment misses the box.
std::optional<std::pair<Point, Point>> clippedToBox(const Point& a, const Point& b, const Box& box);

}  // namespace keyblock
