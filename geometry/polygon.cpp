// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Integrals over a polygon are sums over the triangles between its edges and a reference point. The reference point is
// the first corner for the area and the centroid, and the centroid for the second moments, so that large numbers are
// never subtracted from each other.
#include "geometry/polygon.h"

#include "geometry/segment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

std::size_t following(std::span<const Point> polygon, std::size_t i) { return i + 1 == polygon.size() ? 0 : i + 1; }

/// Calls `visit(p, q)` with the ends of every edge, relative to `origin`.
template <class Visit>
void forEachEdge(std::span<const Point> polygon, const Point& origin, Visit visit) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point p = polygon[i] - origin;
        const Point q = polygon[following(polygon, i)] - origin;
        visit(p, q);
    }
}

/// Centroid relative to the first corner; zero if the area is zero.
Point relativeCentroid(std::span<const Point> polygon, double area) {
    Point sum{0.0, 0.0};
    forEachEdge(polygon, polygon.front(), [&](const Point& p, const Point& q) { sum += cross(p, q) * (p + q); });
    return area != 0.0 ? Point(sum / (6.0 * area)) : Point(0.0, 0.0);
}

}  // namespace

double signedArea(std::span<const Point> polygon) {
    double twice = 0.0;
    if (!polygon.empty())
        forEachEdge(polygon, polygon.front(), [&](const Point& p, const Point& q) { twice += cross(p, q); });
    return 0.5 * twice;
}

Moments moments(std::span<const Point> polygon) {
    assert(!polygon.empty());
    const double area = signedArea(polygon);
    const Point& corner = polygon.front();
    const Point centre = relativeCentroid(polygon, area);
    const double sign = area < 0.0 ? -1.0 : 1.0;

    Moments result;
    result.area = sign * area;
    result.centroid = corner + centre;
    forEachEdge(polygon, corner, [&](const Point& fromCornerP, const Point& fromCornerQ) {
        // ∫x² over the triangle (0, p, q) is p×q/12 · (p² + pq + q²), and similarly for y² and xy.
        const Point p = fromCornerP - centre;
        const Point q = fromCornerQ - centre;
        const double weight = sign * cross(p, q) / 12.0;
        result.sxx += weight * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
        result.syy += weight * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
        result.sxy += weight * (p.x() * p.y() + q.x() * q.y() + 0.5 * (p.x() * q.y() + q.x() * p.y()));
    });
    return result;
}

std::vector<Point> counterClockwise(std::vector<Point> polygon) {
    if (signedArea(polygon) < 0.0) std::reverse(polygon.begin() + 1, polygon.end());
    return polygon;
}

double distanceToBoundary(std::span<const Point> polygon, const Point& p) {
    assert(!polygon.empty());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i)
        least = std::min(least, distanceToSegment(polygon[i], polygon[following(polygon, i)], p));
    return least;
}

Side locate(std::span<const Point> polygon, const Point& p, double tolerance) {
    if (distanceToBoundary(polygon, p) <= tolerance) return Side::Boundary;
    // A ray towards +x enters or leaves the polygon at every edge it crosses. An edge includes only its lower end, so
    // that a corner on the ray counts once.
    bool inside = false;
    forEachEdge(polygon, p, [&](const Point& a, const Point& b) {
        const bool crossesRay = (a.y() > 0.0) != (b.y() > 0.0);
        if (crossesRay && (cross(a, b) > 0.0) == (b.y() > a.y())) inside = !inside;
    });
    return inside ? Side::Inside : Side::Outside;
}

namespace {

/// A point well inside the polygon. The candidates are the midpoints of horizontal chords halfway between successive
/// corner heights; the one farthest from the boundary is taken.
std::optional<Point> deepPoint(std::span<const Point> polygon) {
    std::vector<double> heights;
    for (const Point& p : polygon) heights.push_back(p.y());
    std::sort(heights.begin(), heights.end());
    const Box box = boxOf(polygon);

    std::optional<Point> best;
    double bestDepth = 0.0;
    for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
        const double y = 0.5 * (heights[i] + heights[i + 1]);
        const Point from{box.min.x(), y};
        const Point to{box.max.x(), y};
        for (const auto& [begin, end] : insideIntervals(polygon, from, to, 0.0)) {
            const Point middle = from + 0.5 * (begin + end) * (to - from);
            const double depth = distanceToBoundary(polygon, middle);
            if (depth > bestDepth) {
                best = middle;
                bestDepth = depth;
            }
        }
    }
    return best;
}

bool isDeepInside(std::span<const Point> polygon, const Point& p, double tolerance) {
    return locate(polygon, p, tolerance) == Side::Inside;
}

/// True if the outline of `a` runs through the inside of `b`. The depth along a chord increases towards its middle, so
/// the middle of every part inside is tested.
bool outlineEnters(std::span<const Point> a, std::span<const Point> b, double tolerance) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point& from = a[i];
        const Point& to = a[following(a, i)];
        if (isDeepInside(b, from, tolerance)) return true;
        for (const auto& [begin, end] : insideIntervals(b, from, to, tolerance))
            if (isDeepInside(b, from + 0.5 * (begin + end) * (to - from), tolerance)) return true;
    }
    return false;
}

}  // namespace

bool overlap(std::span<const Point> a, std::span<const Point> b, double tolerance) {
    if (a.empty() || b.empty() || !meets(boxOf(a), boxOf(b))) return false;
    if (outlineEnters(a, b, tolerance) || outlineEnters(b, a, tolerance)) return true;
    // Neither outline enters the other: the polygons are apart or identical.
    const std::optional<Point> within = deepPoint(a);
    return within && isDeepInside(b, *within, tolerance);
}

bool contains(std::span<const Point> outer, std::span<const Point> inner, double tolerance) {
    if (outer.empty() || inner.empty() || outlineEnters(outer, inner, tolerance)) return false;
    const std::optional<Point> within = deepPoint(inner);
    return within && isDeepInside(outer, *within, tolerance);
}

Box boxOf(std::span<const Point> points) {
    assert(!points.empty());
    Box box{points.front(), points.front()};
    for (const Point& p : points) {
        box.min = box.min.cwiseMin(p);
        box.max = box.max.cwiseMax(p);
    }
    return box;
}

}  // namespace keyblock
