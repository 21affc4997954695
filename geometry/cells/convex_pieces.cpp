// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ear clipping: an ear is a convex corner whose triangle contains no other corner. Ears are cut off until nothing is
// left; every simple polygon has one. The widest ear is cut first, so that three collinear corners form a triangle only
// if there is no other choice. Blocks have few corners, so a simple search is fast enough.
#include "geometry/cells/convex_pieces.h"

#include "geometry/orientation.h"
#include "geometry/segment.h"

#include <array>
#include <cassert>
#include <numeric>

namespace keyblock {

namespace {

constexpr double straightTurn = 1e-9;  // sine of the turning angle of a corner that counts as straight

double turn(const Point& a, const Point& b, const Point& c) {
    const Point in = b - a, out = c - b;
    const double lengths = in.norm() * out.norm();
    return lengths > 0.0 ? cross(in, out) / lengths : 0.0;
}

bool isConvex(std::span<const Point> polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n]) < -straightTurn) return false;
    return true;
}

class Clipping {
public:
    explicit Clipping(std::span<const Point> polygon) : polygon_(polygon), left_(polygon.size()) {
        std::iota(left_.begin(), left_.end(), 0);
    }

    std::vector<std::vector<int>> triangles() {
        std::vector<std::vector<int>> pieces;
        while (left_.size() >= 3) {
            if (dropSpike()) continue;
            const std::size_t ear = widestEar();
            pieces.push_back({before(ear), left_[ear], after(ear)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        return pieces;
    }

private:
    const Point& at(int corner) const { return polygon_[corner]; }
    int before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
    int after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    /// Removes a spike, where the outline runs out and back along the same line. Spikes remain where an outline touches
    /// itself.
    bool dropSpike() {
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (at(before(i)) != at(after(i))) continue;
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i % left_.size()));
            return true;
        }
        return false;
    }

    /// The widest ear (largest sine of the turning angle), or the widest corner if there is no ear.
    std::size_t widestEar() const {
        std::size_t best = 0;
        double width = -2.0;
        bool found = false;
        for (std::size_t i = 0; i < left_.size(); ++i) {
            const double sine = turn(at(before(i)), at(left_[i]), at(after(i)));
            const bool ear = sine > 0.0 && isEmpty(i);
            if ((ear && !found) || (ear == found && sine > width)) {
                best = i;
                width = sine;
                found = found || ear;
            }
        }
        return best;
    }

    bool isEmpty(std::size_t ear) const {
        const std::array<Point, 3> triangle{at(before(ear)), at(left_[ear]), at(after(ear))};
        for (std::size_t i = 0; i < left_.size(); ++i) {
            if (left_[i] == before(ear) || i == ear || left_[i] == after(ear)) continue;
            if (reachesInto(triangle, i)) return false;
        }
        return true;
    }

    /// Whether a corner lies in the triangle. Where the outline touches itself at a corner of the triangle: whether a
    /// side that starts there runs into the triangle.
    bool reachesInto(const std::array<Point, 3>& triangle, std::size_t i) const {
        const Point& p = at(left_[i]);
        for (std::size_t k = 0; k < 3; ++k) {
            if (p != triangle[k]) continue;
            const Point &from = triangle[(k + 2) % 3], &to = triangle[(k + 1) % 3];
            const auto leaves = [&](const Point& q) {
                return orientation(p, to, q) > 0 && orientation(from, p, q) > 0;
            };
            return leaves(at(before(i))) || leaves(at(after(i)));
        }
        for (std::size_t k = 0; k < 3; ++k)
            if (orientation(triangle[k], triangle[(k + 1) % 3], p) < 0) return false;
        return true;
    }

    std::span<const Point> polygon_;
    std::vector<int> left_;  // corners not cut off yet
};

}  // namespace

std::vector<std::vector<int>> convexPieces(std::span<const Point> polygon) {
    assert(polygon.size() >= 3);
    if (!isConvex(polygon)) return Clipping(polygon).triangles();
    std::vector<int> all(polygon.size());
    std::iota(all.begin(), all.end(), 0);
    return {all};
}

}  // namespace keyblock
