// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers distinct points. Points that differ only by round-off have the same number,
// and the first of them defines the coordinates.
#pragma once

#include "geometry/point.h"

#include <cassert>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace keyblock {

class PointSet {
public:
    /// \param tolerance [m] distance up to which points count as the same
    /// \pre tolerance > 0; coordinates / tolerance < 2⁶².
    explicit PointSet(double tolerance) : tolerance_(tolerance) { assert(tolerance > 0.0); }

    /// Number of the point nearest to `p` within the tolerance; if there is no such point, `p` is added and given a
    /// new number.
    int number(const Point& p);

    const Point& operator[](int number) const { return points_[number]; }
    int size() const { return static_cast<int>(points_.size()); }

private:
    struct Bin {
        std::int64_t column = 0, row = 0;  // of a square cell as wide as the tolerance

        bool operator==(const Bin&) const = default;
    };
    struct Mixed {
        std::size_t operator()(const Bin& bin) const;
    };

    double tolerance_;
    std::vector<Point> points_;
    std::unordered_map<Bin, int, Mixed> bins_;  // last point in each bin
    std::vector<int> next_;  // per point: the previous point in the same bin; −1: none
};

}  // namespace keyblock
