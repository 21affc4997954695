// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks whether an outline is sound. Because of round-off, a corner on an edge cannot be distinguished from one next
// to it. Therefore, within the tolerance of a corner, the two sides of that corner decide; elsewhere, the crossing of
// two edges decides.
#include "geometry/grid.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keyblock {

namespace {

class Outline {
public:
    Outline(std::span<const Point> polygon, double tolerance) : tolerance_(tolerance) {
        for (const Point& p : polygon)
            if (corners_.empty() || (p - corners_.back()).norm() > tolerance) corners_.push_back(p);
        while (corners_.size() > 1 && (corners_.back() - corners_.front()).norm() <= tolerance) corners_.pop_back();
    }

    /// Only edges whose boxes meet can touch, so that an outline of many corners takes a time proportional to them.
    std::optional<Point> fault() const {
        const int n = static_cast<int>(corners_.size());
        std::vector<Box> boxes;
        for (int i = 0; i < n; ++i) boxes.push_back(boxOfEdge(i));
        const BoxGrid grid(boxes);
        for (int i = 0; i < n; ++i) {
            if (foldsBack(i)) return corner(i);
            for (const int j : grid.meeting(boxes[static_cast<std::size_t>(i)]))
                if (const auto place = faultBetween(i, j)) return place;
        }
        return std::nullopt;
    }

private:
    /// Contains all points within the tolerance of the edge.
    Box boxOfEdge(int i) const {
        const Box edge{corner(i).cwiseMin(corner(i + 1)), corner(i).cwiseMax(corner(i + 1))};
        return grown(edge, tolerance_ + 1e-12 * (edge.max - edge.min).maxCoeff());
    }

    const Point& corner(int i) const {
        const int n = static_cast<int>(corners_.size());
        return corners_[((i % n) + n) % n];
    }

    bool onEdge(const Point& p, int edge) const {
        return distanceToSegment(corner(edge), corner(edge + 1), p) <= tolerance_;
    }

    /// True if the two sides of corner i overlap.
    bool foldsBack(int i) const {
        if (corners_.size() < 3) return false;
        return onEdge(corner(i - 1), i) || onEdge(corner(i + 1), i - 1);
    }

    /// A fault of edge j with edge i, which starts at corner i, or with corner i itself.
    std::optional<Point> faultBetween(int i, int j) const {
        const int n = static_cast<int>(corners_.size());
        const int gap = ((j - i) % n + n) % n;
        const bool ownEdge = gap == 0 || gap == n - 1;
        if (ownEdge) return std::nullopt;
        if (onEdge(corner(i), j)) return passesThrough(i, j);
        const bool neighbours = gap == 1;
        if (neighbours || j < i) return std::nullopt;
        return cutsThrough(i, j);
    }

    /// Corner i lies on edge j. This is a fault if the two sides of the corner leave to opposite sides of the outline
    /// there, or along it.
    std::optional<Point> passesThrough(int i, int j) const {
        const bool atStart = (corner(j) - corner(i)).norm() <= tolerance_;
        const bool atEnd = (corner(j + 1) - corner(i)).norm() <= tolerance_;
        if (atEnd) return std::nullopt;  // reported with edge j + 1, which starts there
        const Point& before = atStart ? corner(j - 1) : corner(j);
        const Point& after = corner(j + 1);
        const Point& in = corner(i - 1);
        const Point& out = corner(i + 1);
        if (liesAlong(corner(i), in, before) || liesAlong(corner(i), in, after) ||
            liesAlong(corner(i), out, before) || liesAlong(corner(i), out, after))
            return corner(i);
        const bool inLeft = isBetween(corner(i), after, in, before);
        const bool outLeft = isBetween(corner(i), after, out, before);
        return inLeft != outLeft ? std::optional(corner(i)) : std::nullopt;
    }

    /// True if the sides from `at` to `p` and from `at` to `q` overlap.
    bool liesAlong(const Point& at, const Point& p, const Point& q) const {
        return distanceToSegment(at, p, q) <= tolerance_ || distanceToSegment(at, q, p) <= tolerance_;
    }

    /// True if, turning counter-clockwise about `at` from `first`, `p` comes before `last`.
    static bool isBetween(const Point& at, const Point& first, const Point& p, const Point& last) {
        const auto angleFromFirst = [&](const Point& q) {
            const double angle = std::atan2(cross(first - at, q - at), (first - at).dot(q - at));
            return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
        };
        return angleFromFirst(p) < angleFromFirst(last);
    }

    /// The point, clear of their corners, where edges i and j cross; none if they do not.
    std::optional<Point> cutsThrough(int i, int j) const {
        const bool nearCorner = onEdge(corner(i + 1), j) || onEdge(corner(j), i) || onEdge(corner(j + 1), i);
        if (nearCorner) return std::nullopt;
        const auto meeting = crossing(corner(i), corner(i + 1), corner(j), corner(j + 1));
        return meeting ? std::optional(meeting->place) : std::nullopt;
    }

    std::vector<Point> corners_;
    double tolerance_;
};

}  // namespace

std::optional<Point> crossesItself(std::span<const Point> polygon, double tolerance) {
    if (!std::ranges::all_of(polygon, [](const Point& p) { return p.allFinite(); })) return std::nullopt;
    return Outline(polygon, tolerance).fault();
}

}  // namespace keyblock
