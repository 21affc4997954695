// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes clipped at the frame of a picture. Not every kind of paper can clip, so parts
// outside are never drawn.
#pragma once

#include "geometry/polygon.h"

#include <optional>
#include <utility>
#include <vector>

namespace keyblock {

/// The part of a polygon in the box; pieces of a non-convex polygon may be connected along the box's sides.
std::vector<Point> clippedToBox(std::vector<Point> polygon, const Box& box);

/// The part of a segment in the box; nothing when it misses.
std::optional<std::pair<Point, Point>> clippedToBox(const Point& a, const Point& b, const Box& box);

}  // namespace keyblock
