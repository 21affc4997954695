// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons against closed forms and against each other: moments, sides, sound
// outlines and overlap. Tolerances are round-off unless said.
#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <numbers>
#include <utility>

namespace keyblock {
namespace {

using Polygon = std::vector<Point>;

Polygon rectangularPolygon(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}; }

Polygon shifted(Polygon polygon, const Point& by) {
    for (Point& p : polygon) p += by;
    return polygon;
}

const Polygon ell{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};

TEST(Moments, OfARectangleAreTheClosedForm) {
    const Moments m = moments(rectangularPolygon(1.0, 2.0, 5.0, 4.0));
    EXPECT_DOUBLE_EQ(m.area, 8.0);
    EXPECT_DOUBLE_EQ(m.centroid.x(), 3.0);
    EXPECT_DOUBLE_EQ(m.centroid.y(), 3.0);
    EXPECT_DOUBLE_EQ(m.sxx, 4.0 * 4.0 * 4.0 * 2.0 / 12.0);
    EXPECT_DOUBLE_EQ(m.syy, 4.0 * 2.0 * 2.0 * 2.0 / 12.0);
    EXPECT_NEAR(m.sxy, 0.0, 1e-14);
}

TEST(Moments, OfARightTriangleHaveTheProductTerm) {
    // Legs b, h: Ixx = h b³/36 about the centroid, Ixy = −b²h²/72.
    const double b = 3.0, h = 2.0;
    const Moments m = moments(Polygon{{0, 0}, {b, 0}, {0, h}});
    EXPECT_DOUBLE_EQ(m.area, 3.0);
    EXPECT_DOUBLE_EQ(m.sxx, h * b * b * b / 36.0);
    EXPECT_DOUBLE_EQ(m.syy, b * h * h * h / 36.0);
    EXPECT_DOUBLE_EQ(m.sxy, -b * b * h * h / 72.0);
}

TEST(Moments, OfAConcaveShapeAddUpFromItsParts) {
    const Moments whole = moments(ell);
    const Moments foot = moments(rectangularPolygon(0, 0, 3, 1));
    const Moments leg = moments(rectangularPolygon(0, 1, 1, 3));
    const Point centroid = (foot.area * foot.centroid + leg.area * leg.centroid) / (foot.area + leg.area);
    const Point toFoot = foot.centroid - centroid;
    const Point toLeg = leg.centroid - centroid;
    EXPECT_NEAR(whole.area, 5.0, 1e-14);
    EXPECT_NEAR((whole.centroid - centroid).norm(), 0.0, 1e-14);
    EXPECT_NEAR(whole.sxx, foot.sxx + leg.sxx + foot.area * toFoot.x() * toFoot.x() + leg.area * toLeg.x() * toLeg.x(),
                1e-13);
    EXPECT_NEAR(whole.sxy, foot.area * toFoot.x() * toFoot.y() + leg.area * toLeg.x() * toLeg.y(), 1e-13);
}

TEST(Moments, AreTheSameForEitherWayRound) {
    const Polygon clockwise(ell.rbegin(), ell.rend());
    EXPECT_DOUBLE_EQ(signedArea(clockwise), -signedArea(ell));
    EXPECT_NEAR(moments(clockwise).area, moments(ell).area, 1e-14);
    EXPECT_NEAR(moments(clockwise).sxx, moments(ell).sxx, 1e-13);
    EXPECT_NEAR(moments(clockwise).sxy, moments(ell).sxy, 1e-13);
}

TEST(Moments, LoseNothingFarFromTheOrigin) {
    // Quarters of a metre are exact at 1e6 m, so the shifted polygon is the same polygon.
    const Polygon polygon{{0, 0}, {1.25, 0.25}, {1.5, 1.75}, {0.5, 2.25}};
    const Moments near = moments(polygon);
    const Moments far = moments(shifted(polygon, {1e6, -1e6}));
    EXPECT_DOUBLE_EQ(far.area, near.area);
    EXPECT_DOUBLE_EQ(far.sxx, near.sxx);
    EXPECT_DOUBLE_EQ(far.syy, near.syy);
    EXPECT_DOUBLE_EQ(far.sxy, near.sxy);
}

TEST(Moments, OfALineAreZero) {
    const Moments m = moments(Polygon{{1, 1}, {2, 2}, {3, 3}});
    EXPECT_EQ(m.area, 0.0);
    EXPECT_EQ(m.centroid, Point(1, 1));
}

TEST(CounterClockwise, TurnsOnlyWhatRunsTheOtherWayAndKeepsTheFirstCorner) {
    const Polygon square = rectangularPolygon(0, 0, 1, 1);
    const Polygon turned{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    EXPECT_EQ(counterClockwise(square), square);
    EXPECT_EQ(counterClockwise(turned), square);
}

TEST(Locate, TellsInsideBoundaryAndOutsideOfAConcaveShape) {
    const double tolerance = 1e-9;
    EXPECT_EQ(locate(ell, {0.5, 2.0}, tolerance), Side::Inside);
    EXPECT_EQ(locate(ell, {2.0, 0.5}, tolerance), Side::Inside);
    EXPECT_EQ(locate(ell, {2.0, 2.0}, tolerance), Side::Outside);
    EXPECT_EQ(locate(ell, {1.0, 2.0}, tolerance), Side::Boundary);
    EXPECT_EQ(locate(ell, {1.0 + 0.5e-9, 2.0}, tolerance), Side::Boundary);
    EXPECT_EQ(locate(ell, {1.0 + 2e-9, 2.0}, tolerance), Side::Outside);
    EXPECT_EQ(locate(ell, {3.0, 1.0}, tolerance), Side::Boundary);
}

TEST(Locate, CountsCornersOnTheRayOnce) {
    const Polygon diamond{{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    EXPECT_EQ(locate(diamond, {0, 0}, 1e-9), Side::Inside);
    EXPECT_EQ(locate(diamond, {-2, 0}, 1e-9), Side::Outside);
    EXPECT_EQ(locate(diamond, {-2, 1}, 1e-9), Side::Outside);
    // Level with the edge y = 1 of the ell, both inside and outside of it.
    EXPECT_EQ(locate(ell, {0.5, 1.0}, 1e-9), Side::Inside);
    EXPECT_EQ(locate(ell, {-1.0, 1.0}, 1e-9), Side::Outside);
}

TEST(DistanceToBoundary, IsTheNearestEdgeFromEitherSide) {
    const Polygon square = rectangularPolygon(0, 0, 2, 2);
    EXPECT_DOUBLE_EQ(distanceToBoundary(square, {0.5, 1.0}), 0.5);
    EXPECT_DOUBLE_EQ(distanceToBoundary(square, {5.0, 6.0}), 5.0);
}

TEST(CrossesItself, PassesSoundOutlines) {
    EXPECT_FALSE(crossesItself(rectangularPolygon(0, 0, 1, 1), 1e-9));
    EXPECT_FALSE(crossesItself(ell, 1e-9));
    EXPECT_FALSE(crossesItself(Polygon{{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, 1e-9));  // repeated corners
    EXPECT_FALSE(crossesItself(Polygon{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}, 1e-9));  // corner on a straight side
}

TEST(CrossesItself, TakesOutlinesOfManyCorners) {
    Polygon circle;
    for (int i = 0; i < 30000; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 30000;
        circle.emplace_back(std::cos(angle), std::sin(angle));
    }
    const std::clock_t start = std::clock();
    EXPECT_FALSE(crossesItself(circle, 1e-9));
    std::swap(circle[29000], circle[29001]);
    EXPECT_TRUE(crossesItself(circle, 1e-9));
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 5.0);  // comparing all edges takes a minute
}

TEST(CrossesItself, DoesNotExamineWhatIsNotFinite) {
    const double nan = std::nan("");
    EXPECT_FALSE(crossesItself(Polygon{{0, 0}, {nan, 2}, {2, 0}, {0, 2}}, 1e-9));
}

TEST(CrossesItself, FindsTheWaistOfABowTie) {
    const auto place = crossesItself(Polygon{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, 1e-9);
    ASSERT_TRUE(place);
    EXPECT_NEAR((*place - Point(1, 1)).norm(), 0.0, 1e-15);
}

TEST(CrossesItself, FindsACrossingThatGoesThroughACorner) {
    // The edge (0,0)–(2,2) is crossed at the corner (1,1), then at a corner of its own.
    EXPECT_TRUE(crossesItself(Polygon{{0, 0}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}, 1e-9));
    EXPECT_TRUE(crossesItself(Polygon{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}, 1e-9));
}

TEST(CrossesItself, AllowsTouchingInAPoint) {
    // A corner reaches the opposite side and goes back.
    EXPECT_FALSE(crossesItself(Polygon{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}, 1e-9));
    // Two corners meet, each side staying on its own side.
    EXPECT_FALSE(crossesItself(Polygon{{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}, 1e-9));
}

TEST(CrossesItself, FindsSidesThatRunAlongEachOther) {
    EXPECT_TRUE(crossesItself(Polygon{{0, 0}, {2, 0}, {1, 0}, {1, 1}}, 1e-9));  // folds back
    // A slit of no width into the square.
    EXPECT_TRUE(crossesItself(Polygon{{0, 0}, {1, 0}, {1, 1}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 1e-9));
}

TEST(Overlap, IgnoresASharedSeam) {
    const Polygon square = rectangularPolygon(0, 0, 1, 1);
    EXPECT_FALSE(overlap(square, rectangularPolygon(1, 0, 2, 1), 1e-6));
    EXPECT_FALSE(overlap(square, rectangularPolygon(1 - 0.5e-6, 0.2, 2, 0.8), 1e-6));
    EXPECT_FALSE(overlap(square, rectangularPolygon(3, 3, 4, 4), 1e-6));
}

TEST(Overlap, SeesEveryWayOfSharingInterior) {
    const Polygon square = rectangularPolygon(0, 0, 1, 1);
    EXPECT_TRUE(overlap(square, rectangularPolygon(1 - 3e-6, 0, 2, 1), 1e-6));  // a strip
    EXPECT_TRUE(overlap(square, square, 1e-6));  // the same twice
    EXPECT_TRUE(overlap(square, rectangularPolygon(0.4, 0.4, 0.6, 0.6), 1e-6));  // one within the other
    EXPECT_TRUE(overlap(rectangularPolygon(-1, 0.4, 2, 0.6), rectangularPolygon(0.4, -1, 0.6, 2), 1e-6));  // a cross, no corner inside
    EXPECT_TRUE(overlap(square, rectangularPolygon(0, 0, 1, 0.5), 1e-6));  // three sides in common
}

TEST(Overlap, KnowsThatAConcaveShapeLeavesRoom) {
    EXPECT_FALSE(overlap(ell, rectangularPolygon(1, 1, 3, 3), 1e-6));
    EXPECT_TRUE(overlap(ell, rectangularPolygon(0.9, 0.9, 3, 3), 1e-6));
}

TEST(Contains, AsksForAllOfIt) {
    const Polygon square = rectangularPolygon(0, 0, 1, 1);
    EXPECT_TRUE(contains(square, rectangularPolygon(0.4, 0.4, 0.6, 0.6), 1e-6));
    EXPECT_TRUE(contains(square, rectangularPolygon(0.4, 0, 0.6, 0.2), 1e-6));  // on its floor
    EXPECT_TRUE(contains(square, square, 1e-6));
    EXPECT_TRUE(contains(square, rectangularPolygon(0.5, 0.5, 1 + 0.5e-6, 0.8), 1e-6));
    EXPECT_FALSE(contains(square, rectangularPolygon(0.5, 0.5, 1.1, 0.8), 1e-6));  // through a side
    EXPECT_FALSE(contains(square, rectangularPolygon(3, 3, 4, 4), 1e-6));
    EXPECT_FALSE(contains(rectangularPolygon(0.4, 0.4, 0.6, 0.6), square, 1e-6));  // the other way round
    EXPECT_FALSE(contains(ell, rectangularPolygon(0.5, 0.5, 2, 2), 1e-6));  // all corners but one, across the notch
}

TEST(Box, HoldsGrowsAndMeets) {
    const Box box = boxOf(ell);
    EXPECT_EQ(box.min, Point(0, 0));
    EXPECT_EQ(box.max, Point(3, 3));
    EXPECT_EQ(grown(box, 0.5).min, Point(-0.5, -0.5));
    EXPECT_TRUE(meets(box, {{3, 3}, {4, 4}}));
    EXPECT_FALSE(meets(box, {{3.1, 0}, {4, 4}}));
}

}  // namespace
}  // namespace keyblock
