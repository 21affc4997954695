// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Feet, crossings, and bolts through blocks.
#include "geometry/segment.h"

#include "tests/geometry/intervals.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

TEST(Foot, RunsFromZeroToOneAndBeyond) {
    EXPECT_DOUBLE_EQ(footParameter({1, 1}, {3, 1}, {2, 7}), 0.5);
    EXPECT_DOUBLE_EQ(footParameter({1, 1}, {3, 1}, {5, -7}), 2.0);
    EXPECT_EQ(footParameter({1, 1}, {1, 1}, {5, -7}), 0.0);
}

TEST(DistanceToSegment, EndsWhereTheSegmentEnds) {
    EXPECT_DOUBLE_EQ(distanceToSegment({0, 0}, {4, 0}, {1, 2}), 2.0);
    EXPECT_DOUBLE_EQ(distanceToSegment({0, 0}, {4, 0}, {7, 4}), 5.0);
    EXPECT_DOUBLE_EQ(distanceToSegment({0, 0}, {0, 0}, {3, 4}), 5.0);
}

TEST(Crossing, GivesPlaceAndParameters) {
    const auto found = crossing({0, 0}, {4, 0}, {1, -1}, {1, 3});
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->onFirst, 0.25);
    EXPECT_DOUBLE_EQ(found->onSecond, 0.25);
    EXPECT_EQ(found->place, Point(1, 0));
}

TEST(Crossing, IsNoneWhenTheyMissOrRunParallel) {
    EXPECT_FALSE(crossing({0, 0}, {4, 0}, {5, -1}, {5, 1}));
    EXPECT_FALSE(crossing({0, 0}, {4, 0}, {1, 0}, {3, 0}));
    EXPECT_FALSE(crossing({0, 0}, {4, 0}, {1, 1}, {3, 1}));
}

TEST(InsideIntervals, OfABoltThroughOneBlock) {
    expectIntervals(insideIntervals(square, {-1, 0.5}, {3, 0.5}, tolerance), {{0.25, 0.5}});
    expectIntervals(insideIntervals(square, {0.25, 0.5}, {0.75, 0.5}, tolerance), {{0.0, 1.0}});
    expectIntervals(insideIntervals(square, {0.5, 0.5}, {0.5, 2.5}, tolerance), {{0.0, 0.25}});
    expectIntervals(insideIntervals(square, {-1, 3}, {3, 3}, tolerance), {});
}

TEST(InsideIntervals, OfAConcaveBlockAreSeveral) {
    expectIntervals(insideIntervals(comb, {-2.5, 1.5}, {7.5, 1.5}, tolerance), {{0.25, 0.35}, {0.45, 0.55}, {0.65, 0.75}});
}

TEST(InsideIntervals, LeaveOutWhatRunsAlongAnEdge) {
    expectIntervals(insideIntervals(square, {-1, 1}, {3, 1}, tolerance), {});
    // Along y = 1 the comb is inside under its teeth and on its boundary between them.
    expectIntervals(insideIntervals(comb, {0, 1}, {5, 1}, tolerance), {{0.0, 0.2}, {0.4, 0.6}, {0.8, 1.0}});
}

TEST(InsideIntervals, GoOnPastACornerTouchedFromWithin) {
    const Polygon notched{{0, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 1}, {1, 2}, {0, 2}};
    expectIntervals(insideIntervals(notched, {0, 1}, {4, 1}, tolerance), {{0.0, 1.0}});
}

TEST(InsideIntervals, ThroughCornersAreWhole) {
    expectIntervals(insideIntervals(square, {-1, -1}, {2, 2}, tolerance), {{1.0 / 3.0, 2.0 / 3.0}});
    expectIntervals(insideIntervals(square, {-1, 1}, {1, -1}, tolerance), {});  // touches one corner
}

}  // namespace
}  // namespace keyblock
