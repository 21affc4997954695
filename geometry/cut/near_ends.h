// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Finds points that are close to each other or to segments, in time roughly
// proportional to their number: points are stored in the cells of a grid, and for a
// segment only the cells that it runs through are searched.
#pragma once

#include "geometry/polygon.h"

#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// Points merged into locations: points close to each other share one location.
struct Gathered {
    std::vector<Point> places;  // locations, more than the radius apart except for fixed ones
    std::vector<int> placeOf;  // per point: index of its location
};

/// Assigns each point, in the order given, to the nearest location within the radius, or makes it a new location.
/// \param fixed number of points at the start of the list that become locations even if they are close to others;
/// among these points only identical ones share a location
/// \param radius [m]
Gathered gather(std::span<const Point> points, std::size_t fixed, double radius);

/// Faster alternative to `gather` for a radius of the order of round-off. Points that are no farther apart than the
/// radius, directly or through a chain of points, share one location. This location is the first of these points in
/// increasing order of x, then y; if some of them are fixed, it is the first of the fixed ones. Locations are sorted in
/// the same order.
/// \param fixed number of fixed points at the start of the list
/// \param radius [m]
Gathered gatherSorted(std::span<const Point> points, std::size_t fixed, double radius);

/// A segment between two locations, given by their indices.
struct PlacePair {
    int from = 0, to = 0;
};

/// All pairs (index of a location, index of a segment) whose distance is at most the radius, sorted. A segment is not
/// paired with its own ends, and locations more than the radius outside `box` are ignored. \param radius [m]
std::vector<std::pair<int, int>> nearPairs(std::span<const Point> places, std::span<const PlacePair> segments,
                                           const Box& box, double radius);

}  // namespace keyblock
