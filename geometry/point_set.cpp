// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points within the tolerance of a point are in its bin or in one of the eight bins around it.
#include "geometry/point_set.h"

#include <cassert>
#include <cmath>

namespace keyblock {

std::size_t PointSet::Mixed::operator()(const Bin& bin) const {
    const auto c = static_cast<std::uint64_t>(bin.column), r = static_cast<std::uint64_t>(bin.row);
    const std::uint64_t mixed = (c * 0x9E3779B97F4A7C15u) ^ ((r + 0x9E3779B97F4A7C15u) * 0xBF58476D1CE4E5B9u);
    return mixed ^ (mixed >> 29);
}

int PointSet::number(const Point& p) {
    assert(p.cwiseAbs().maxCoeff() / tolerance_ < 0x1p62);
    const Bin own{static_cast<std::int64_t>(std::floor(p.x() / tolerance_)),
                  static_cast<std::int64_t>(std::floor(p.y() / tolerance_))};
    int nearest = -1;
    double least = tolerance_;
    for (std::int64_t column = own.column - 1; column <= own.column + 1; ++column)
        for (std::int64_t row = own.row - 1; row <= own.row + 1; ++row) {
            const auto found = bins_.find({column, row});
            for (int i = found == bins_.end() ? -1 : found->second; i >= 0; i = next_[i]) {
                const double distance = ((*this)[i] - p).norm();
                if (distance > least || (distance == least && nearest >= 0 && nearest < i)) continue;
                least = distance;
                nearest = i;
            }
        }
    if (nearest >= 0) return nearest;
    const auto [place, added] = bins_.try_emplace(own, size());
    next_.push_back(added ? -1 : place->second);
    place->second = size();
    points_.push_back(p);
    return size() - 1;
}

}  // namespace keyblock
