// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One number for each place: points that differ by round-off are the same, and
// the first point at a place defines its doubles from then on.
#pragma once

#include "geometry/point.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace keyblock {

class PointSet {
public:
    /// Points no farther apart than `tolerance` [m] are one. \pre tolerance > 0; coordinates over tolerance below 2⁶².
    explicit PointSet(double tolerance) : tolerance_(tolerance) {}

    /// The number of the place nearest to `p` within the tolerance, or else that of a new place at `p`.
    int number(const Point& p);

    const Point& operator[](int number) const { return points_[static_cast<std::size_t>(number)]; }
    int size() const { return static_cast<int>(points_.size()); }

private:
    struct Bin {
        std::int64_t column = 0, row = 0;  // squares as wide as the tolerance

        bool operator==(const Bin&) const = default;
    };
    struct Mixed {
        std::size_t operator()(const Bin& bin) const;
    };

    double tolerance_;
    std::vector<Point> points_;
    std::unordered_map<Bin, int, Mixed> bins_;  // a second place of one bin is in `next_` of the first
    std::vector<int> next_;
};

}  // namespace keyblock
