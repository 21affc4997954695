// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of a segment inside a polygon are found by cutting the segment wherever an edge or a corner is near and
// testing the midpoint of each piece. The midpoint is far from the boundary or lies along it, so the result does not
// depend on the last digit of a crossing.
#include "geometry/segment.h"

#include "geometry/polygon.h"

#include <algorithm>

namespace keyblock {

double footParameter(const Point& a, const Point& b, const Point& p) {
    const Point direction = b - a;
    const double lengthSquared = direction.squaredNorm();
    return lengthSquared > 0.0 ? direction.dot(p - a) / lengthSquared : 0.0;
}

double distanceToSegment(const Point& a, const Point& b, const Point& p) {
    const double t = std::clamp(footParameter(a, b, p), 0.0, 1.0);
    return ((p - a) - t * (b - a)).norm();
}

std::optional<Crossing> crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
    const Point first = b - a;
    const Point second = d - c;
    const double denominator = cross(first, second);
    if (denominator == 0.0) return std::nullopt;
    const double onFirst = cross(c - a, second) / denominator;
    const double onSecond = cross(c - a, first) / denominator;
    if (onFirst < 0.0 || onFirst > 1.0 || onSecond < 0.0 || onSecond > 1.0) return std::nullopt;
    return Crossing{onFirst, onSecond, a + onFirst * first};
}

namespace {

/// Sorted parameters of a→b, including both ends, between which the segment neither meets nor leaves an edge.
std::vector<double> cuts(std::span<const Point> polygon, const Point& a, const Point& b, double tolerance) {
    std::vector<double> at{0.0, 1.0};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& c = polygon[i];
        const Point& d = polygon[(i + 1) % polygon.size()];
        if (const auto meeting = crossing(a, b, c, d)) at.push_back(meeting->onFirst);
        if (distanceToSegment(a, b, c) <= tolerance) at.push_back(std::clamp(footParameter(a, b, c), 0.0, 1.0));
    }
    std::sort(at.begin(), at.end());
    return at;
}

}  // namespace

std::vector<std::pair<double, double>> insideIntervals(std::span<const Point> polygon, const Point& a, const Point& b,
                                                       double tolerance) {
    const double length = (b - a).norm();
    const std::vector<double> at = cuts(polygon, a, b, tolerance);
    std::vector<std::pair<double, double>> inside;
    for (std::size_t i = 0; i + 1 < at.size(); ++i) {
        // Two cuts at the same corner differ only by round-off; the sliver between them is ignored.
        if ((at[i + 1] - at[i]) * length <= tolerance) continue;
        const Point middle = a + 0.5 * (at[i] + at[i + 1]) * (b - a);
        if (locate(polygon, middle, tolerance) != Side::Inside) continue;
        const bool continues = !inside.empty() && (at[i] - inside.back().second) * length <= tolerance;
        if (continues)
            inside.back().second = at[i + 1];
        else
            inside.emplace_back(at[i], at[i + 1]);
    }
    return inside;
}

}  // namespace keyblock
