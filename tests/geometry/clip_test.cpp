// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines through polygons: parts, corners, edges, and nothing that hangs on how
// long a line is asked for.
#include "geometry/clip.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "tests/geometry/intervals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace keyblock {
namespace {

TEST(DirectionOf, IsExactAtQuarterTurns) {
    for (const int turns : {-8, -4, 0, 4, 1000}) {
        EXPECT_EQ(directionOf(90.0 * turns), Point(1, 0));
        EXPECT_EQ(directionOf(90.0 * turns + 90.0), Point(0, 1));
        EXPECT_EQ(directionOf(90.0 * turns + 180.0), Point(-1, 0));
        EXPECT_EQ(directionOf(90.0 * turns + 270.0), Point(0, -1));
    }
    for (double degrees = -400.0; degrees < 400.0; degrees += 7.3) {
        EXPECT_NEAR(directionOf(degrees).x(), std::cos(degrees * radiansPerDegree), 1e-14);
        EXPECT_NEAR(directionOf(degrees).y(), std::sin(degrees * radiansPerDegree), 1e-14);
    }
}

TEST(Clipped, KeepsWhatLiesInside) {
    expectIntervals(clipped(square, {-1, 0.5}, {1, 0}, -10, 10, tolerance), {{1, 2}});
    expectIntervals(clipped(square, {0.2, 0.5}, {1, 0}, 0, 0.5, tolerance), {{0, 0.5}});
    expectIntervals(clipped(square, {0.2, 0.5}, {0, 1}, -10, 0.1, tolerance), {{-0.5, 0.1}});
    expectIntervals(clipped(square, {-1, 3}, {1, 0}, -10, 10, tolerance), {});
    expectIntervals(clipped(square, {-1, 0.5}, {1, 0}, -10, 0.5, tolerance), {});
}

TEST(Clipped, EndsInsideComeBackUnchanged) {
    const Point along = directionOf(33.0);
    const auto parts = clipped(square, {0.5, 0.5}, along, -0.1234567, 0.3 / 7.0, tolerance);
    ASSERT_EQ(parts.size(), 1u);
    EXPECT_EQ(parts[0].first, -0.1234567);
    EXPECT_EQ(parts[0].second, 0.3 / 7.0);
}

TEST(Clipped, FallsIntoPiecesInAConcavePolygon) {
    expectIntervals(clipped(comb, {0, 1.5}, {1, 0}, -10, 10, tolerance), {{0, 1}, {2, 3}, {4, 5}});
    expectIntervals(clipped(comb, {0, 0.5}, {1, 0}, -10, 10, tolerance), {{0, 5}});
}

TEST(Clipped, TheOutlineBelongsToThePolygon) {
    expectIntervals(clipped(square, {0, 0}, {1, 0}, -10, 10, tolerance), {{0, 1}});
    expectIntervals(clipped(square, {1, 0}, {0, 1}, -10, 10, tolerance), {{0, 1}});
    expectIntervals(clipped(comb, {0, 1}, {1, 0}, -10, 10, tolerance), {{0, 5}});  // along two slots' ends
    expectIntervals(clipped(comb, {0, 2}, {1, 0}, -10, 10, tolerance), {{0, 1}, {2, 3}, {4, 5}});  // along the teeth
    expectIntervals(clipped(square, {0, -0.5 * tolerance}, {1, 0}, -10, 10, tolerance), {{0, 1}});
    expectIntervals(clipped(square, {0, -2.0 * tolerance}, {1, 0}, -10, 10, tolerance), {});
}

TEST(Clipped, ATouchedCornerIsNoPart) {
    const double half = std::sqrt(0.5);
    expectIntervals(clipped(square, {1, 0}, {half, half}, -10, 10, tolerance), {});
    expectIntervals(clipped(square, {0, 0}, {half, half}, -10, 10, tolerance), {{0, std::sqrt(2.0)}});
    expectIntervals(clipped(comb, {1, 1}, {half, half}, -10, 10, tolerance), {{-std::sqrt(2.0), 0}});
}

TEST(Clipped, APartDoesNotHangOnHowMuchIsAskedFor) {
    const Point along = directionOf(21.7);
    const auto once = clipped(comb, {0.3, 0.9}, along, -3, 4, tolerance);
    ASSERT_FALSE(once.empty());
    EXPECT_EQ(clipped(comb, {0.3, 0.9}, along, -1e6, 1e5, tolerance), once);
}

// Between neighbouring corners the length of the parts is linear in the line's place, so its integral over the places,
// the area, is exactly the sum of the lengths half-way between corners times the distances.
TEST(Clipped, ParallelPartsAddUpToTheArea) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> radius(0.3, 2.0), angle(0.0, 180.0);
    for (int round = 0; round < 200; ++round) {
        Polygon star;
        for (int i = 0; i < 17; ++i) star.push_back(radius(random) * directionOf(360.0 * i / 17));
        const Point along = directionOf(angle(random)), across = turnLeft(along);
        std::vector<double> corners;
        for (const Point& p : star) corners.push_back(across.dot(p));
        std::sort(corners.begin(), corners.end());
        double area = 0.0;
        for (std::size_t i = 0; i + 1 < corners.size(); ++i)
            for (const auto& [begin, end] :
                 clipped(star, 0.5 * (corners[i] + corners[i + 1]) * across, along, -10, 10, 1e-12))
                area += (end - begin) * (corners[i + 1] - corners[i]);
        EXPECT_NEAR(area, signedArea(star), 1e-12) << round;
    }
}

}  // namespace
}  // namespace keyblock
