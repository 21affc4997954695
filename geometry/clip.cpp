// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The line is cut wherever an edge crosses it or a corner lies close to it, and the midpoint of each piece decides
// whether the piece lies inside. The midpoint is either far from every edge that the line crosses, or lies along an
// edge, so the result does not depend on the last digit.
#include "geometry/clip.h"

#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Sorted values of s, including both ends, between which the line neither enters nor leaves the polygon.
std::vector<double> cuts(std::span<const Point> polygon, const Point& place, const Point& along, double begin,
                         double end, double tolerance) {
    std::vector<double> at{begin, end};
    const auto add = [&](double s) {
        if (s > begin && s < end) at.push_back(s);
    };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i] - place;
        const Point b = polygon[(i + 1) % polygon.size()] - place;
        const double offA = cross(along, a);
        const double offB = cross(along, b);
        if (std::abs(offA) <= tolerance) add(along.dot(a));
        if ((offA < 0.0) == (offB < 0.0)) continue;
        const double share = offA / (offA - offB);
        add(along.dot(a) + share * along.dot(b - a));
    }
    std::sort(at.begin(), at.end());
    return at;
}

}  // namespace

std::vector<std::pair<double, double>> clipped(std::span<const Point> polygon, const Point& place, const Point& along,
                                               double begin, double end, double tolerance) {
    const std::vector<double> at = cuts(polygon, place, along, begin, end, tolerance);
    std::vector<std::pair<double, double>> kept;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        // Two cuts at the same corner differ only by round-off; the sliver between them is ignored.
        if (at[i + 1] - at[i] <= tolerance) continue;
        const Point middle = place + 0.5 * (at[i] + at[i + 1]) * along;
        if (locate(polygon, middle, tolerance) == Side::Outside) continue;
        if (!kept.empty() && at[i] - kept.back().second <= tolerance)
            kept.back().second = at[i + 1];
        else
            kept.emplace_back(at[i], at[i + 1]);
    }
    // A skipped sliver at an end still belongs to the adjacent part.
    if (!kept.empty() && kept.front().first - begin <= tolerance) kept.front().first = begin;
    if (!kept.empty() && end - kept.back().second <= tolerance) kept.back().second = end;
    return kept;
}

}  // namespace keyblock
