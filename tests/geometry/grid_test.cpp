// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The grid against asking every pair, on boxes of all sizes.
#include "geometry/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace keyblock {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs everyPair(const std::vector<Box>& boxes) {
    Pairs pairs;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (meets(boxes[i], boxes[j])) pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
    return pairs;
}

/// Boxes whose sizes spread over `decades`, in a square of 100 m at `origin`.
std::vector<Box> scattered(int count, double decades, const Point& origin) {
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const Point corner = origin + Point(100.0 * unit(), 100.0 * unit());
        const double size = 10.0 * std::pow(10.0, -decades * unit());
        boxes.push_back({corner, corner + Point(size * unit(), size * unit())});
    }
    return boxes;
}

TEST(BoxGrid, FindsTheSamePairsAsAskingAll) {
    for (const double decades : {0.0, 1.0, 4.0}) {
        const std::vector<Box> boxes = scattered(600, decades, {0, 0});
        const Pairs expected = everyPair(boxes);
        ASSERT_FALSE(expected.empty());
        EXPECT_EQ(BoxGrid(boxes).meetingPairs(), expected) << decades << " decades of size";
    }
}

TEST(BoxGrid, ComparesOnlyBoxesNearby) {
    const std::vector<Box> boxes = scattered(10000, 4.0, {0, 0});
    const BoxGrid grid(boxes);
    const Box box{{50, 50}, {50.5, 50.5}};
    const std::size_t met = grid.meeting(box).size();
    EXPECT_GT(met, 0u);
    EXPECT_GE(grid.compared(box), met);
    EXPECT_LT(grid.compared(box), boxes.size() / 20);
}

TEST(BoxGrid, WorksFarFromTheOrigin) {
    const std::vector<Box> boxes = scattered(400, 1.0, {1e6, -1e6});
    EXPECT_EQ(BoxGrid(boxes).meetingPairs(), everyPair(boxes));
}

TEST(BoxGrid, CountsTouchingBoxesOfAWall) {
    std::vector<Box> wall;
    for (int row = 0; row < 20; ++row)
        for (int column = 0; column < 20; ++column)
            wall.push_back({{1e6 + 0.1 * column, 0.1 * row}, {1e6 + 0.1 * (column + 1), 0.1 * (row + 1)}});
    const Pairs pairs = BoxGrid(wall).meetingPairs();
    EXPECT_EQ(pairs, everyPair(wall));
    EXPECT_EQ(pairs.size(), 2u * 20u * 19u + 2u * 19u * 19u);  // sides and diagonals
}

TEST(BoxGrid, HoldsASlabAmongPebblesPointsAndNothing) {
    std::vector<Box> boxes = scattered(200, 0.5, {0, 0});
    boxes.push_back({{-1e4, -1e4}, {1e4, 1e4}});
    boxes.push_back({{50, 50}, {50, 50}});
    boxes.push_back({{50, 50}, {50, 50}});
    EXPECT_EQ(BoxGrid(boxes).meetingPairs(), everyPair(boxes));
    EXPECT_TRUE(BoxGrid({}).meetingPairs().empty());
    EXPECT_EQ(BoxGrid({boxes[201], boxes[202]}).meetingPairs(), (Pairs{{0, 1}}));
}

TEST(BoxGrid, AnswersForAnyBox) {
    const std::vector<Box> boxes = scattered(300, 2.0, {0, 0});
    const BoxGrid grid(boxes);
    for (const Box& query : {Box{{10, 10}, {30, 15}}, Box{{-1e9, -1e9}, {1e9, 1e9}}, Box{{200, 0}, {300, 1}}}) {
        std::vector<int> expected;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (meets(boxes[i], query)) expected.push_back(static_cast<int>(i));
        EXPECT_EQ(grid.meeting(query), expected);
    }
}

/// A run that fails may ask with positions that are not numbers.
TEST(BoxGrid, FindsNothingWhereABoxHasNoPlace) {
    const BoxGrid grid(scattered(30, 2.0, {0, 0}));
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(grid.meeting({{none, none}, {none, none}}).empty());
    EXPECT_TRUE(grid.meeting({{none, 0}, {10, none}}).empty());
}

}  // namespace
}  // namespace keyblock
