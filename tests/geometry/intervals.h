// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons that lines are led through, and the parts of a line that are expected
// inside them.
#pragma once

#include "geometry/point.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace keyblock {

using Polygon = std::vector<Point>;
using Intervals = std::vector<std::pair<double, double>>;

inline constexpr double tolerance = 1e-9;
inline const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
inline const Polygon comb{{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

inline void expectIntervals(const Intervals& found, const Intervals& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].first, expected[i].first, 1e-12) << "interval " << i;
        EXPECT_NEAR(found[i].second, expected[i].second, 1e-12) << "interval " << i;
    }
}

}  // namespace keyblock
