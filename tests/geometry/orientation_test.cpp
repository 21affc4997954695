// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides against whole numbers of 128 bits, where doubles alone would guess.
#include "geometry/orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace keyblock {
namespace {

__extension__ using Wide = __int128;

TEST(Orientation, IsThatOfWholeNumbers) {
    std::mt19937_64 random(4);
    int onLine = 0, doubtful = 0;
    for (int i = 0; i < 100000; ++i) {
        const auto whole = [&](int bits) { return static_cast<std::int64_t>(random() >> (64 - bits)); };
        // c = a + k·(b − a) up to a step aside: products of 2^100
        const std::int64_t ax = whole(49), ay = whole(49), dx = whole(40), dy = whole(40), k = whole(8);
        const std::int64_t bx = ax + dx, by = ay + dy, cx = ax + k * dx + whole(1) - whole(1), cy = ay + k * dy;
        const Wide exact = Wide(bx - ax) * (cy - ay) - Wide(by - ay) * (cx - ax);
        const auto point = [](std::int64_t x, std::int64_t y) {
            return Point(std::ldexp(static_cast<double>(x), -60), std::ldexp(static_cast<double>(y), -60));
        };
        const Point a = point(ax, ay), b = point(bx, by), c = point(cx, cy);
        const int expected = exact > 0 ? 1 : exact < 0 ? -1 : 0;
        ASSERT_EQ(orientation(a, b, c), expected);
        ASSERT_EQ(orientation(b, c, a), expected);
        ASSERT_EQ(orientation(b, a, c), -expected);
        onLine += expected == 0;
        doubtful += expected != 0 && cross(b, c) + cross(c, a) + cross(a, b) == 0.0;
    }
    EXPECT_GT(onLine, 1000);
    EXPECT_GT(doubtful, 100);
}

TEST(Orientation, SegmentsMeetWhereTheyShareAPoint) {
    EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
    EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {1, 1}, {5, 0}));
    EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {2, 2}, {3, 0}));
    EXPECT_TRUE(segmentsMeet({0, 0}, {2, 2}, {1, 1}, {3, 3}));
    EXPECT_FALSE(segmentsMeet({0, 0}, {2, 2}, {3, 3}, {4, 4}));
    EXPECT_FALSE(segmentsMeet({0, 0}, {2, 2}, {1.0 + 3e-16, 1}, {5, 0}));
    EXPECT_FALSE(segmentsMeet({0, 0}, {2, 0}, {0, 1e-300}, {2, 1e-300}));
}

}  // namespace
}  // namespace keyblock
