// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points come close to each other, and which to segments, in time about
// proportional to their number: points lie in the cells of a grid, and a segment
// looks into the cells that it runs through.
#pragma once

#include "geometry/polygon.h"

#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// Puts points that are close to each other together.
struct Gathered {
    std::vector<Point> places;  // more than the radius apart from each other, but for the fixed ones
    std::vector<int> placeOf;  // of each point
};

/// Each point goes to the nearest place within `radius` [m], or becomes a place, in the order given. The first
/// `fixed` points become places regardless of what they are close to, unless they are the very same.
Gathered gather(std::span<const Point> points, std::size_t fixed, double radius);

/// The same for a radius of round-off, much faster: points closer than `radius` [m] to each other go together, in
/// chains too, to the lowest of the first `fixed` among them, or else to the lowest. Places rise in x, then y.
Gathered gatherSorted(std::span<const Point> points, std::size_t fixed, double radius);

/// A segment between two places.
struct PlacePair {
    int from = 0, to = 0;
};

/// All pairs (place, segment) no farther apart than `radius` [m], but for the segment's own ends; sorted.
/// Places outside `box` are left out.
std::vector<std::pair<int, int>> nearPairs(std::span<const Point> places, std::span<const PlacePair> segments,
                                           const Box& box, double radius);

}  // namespace keyblock
