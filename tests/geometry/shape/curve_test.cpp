// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves whose points, lengths and areas are known in closed form.
#include "geometry/shape/curve.h"

#include "geometry/polygon.h"
#include "geometry/segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// The farthest that the edge between two points of a circle lies off it.
double sagittaOf(const std::vector<Point>& points, const Point& center, double radius) {
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        largest = std::max(largest, radius - (0.5 * (points[i] + points[i + 1]) - center).norm());
    return largest;
}

TEST(Curve, AnArcKeepsItsSagitta) {
    for (const double sagitta : {1.0, 0.02, 1e-3, 1e-4}) {
        const auto points = ellipsePoints({3, 4}, {5, 0}, {0, 5}, 0.3, 1.2, sagitta);
        EXPECT_LE(sagittaOf(points, {3, 4}, 5.0), sagitta * (1 + 1e-9));
        for (const Point& p : points) EXPECT_NEAR((p - Point(3, 4)).norm(), 5.0, 1e-14 * 10);
    }
    EXPECT_EQ(ellipsePoints({0, 0}, {1, 0}, {0, 1}, 0, 2 * std::numbers::pi, 1.0).size(), 33U);  // never coarser
    EXPECT_EQ(ellipsePoints({0, 0}, {1, 0}, {0, 1}, 0, 2 * std::numbers::pi, 1e-30).size(), 4097U);  // nor finer
}

TEST(Curve, BulgesAreArcs) {
    // A half circle to the right of the line upwards; its middle lies on x = 1.
    const auto half = bulgePoints({0, 0}, {0, 2}, 1.0, 1e-4);
    for (const Point& p : half) EXPECT_NEAR((p - Point(0, 1)).norm(), 1.0, 1e-14);
    EXPECT_NEAR(half[half.size() / 2].x(), 1.0, 1e-3);
    EXPECT_EQ(half.front(), Point(0, 0));
    EXPECT_EQ(half.back(), Point(0, 2));
    // Its mirror image to the left.
    EXPECT_LT(bulgePoints({0, 0}, {0, 2}, -1.0, 1e-4)[3].x(), 0.0);
    // A quarter circle: radius of the chord over √2.
    const double quarter = std::tan(std::numbers::pi / 8);
    const Point center(-1, 1);  // left of (0,0)→(0,2)
    for (const Point& p : bulgePoints({0, 0}, {0, 2}, quarter, 1e-3)) EXPECT_NEAR((p - center).norm(), std::sqrt(2.0), 1e-14);
    // Three quarters.
    for (const Point& p : bulgePoints({0, 0}, {0, 2}, std::tan(3 * std::numbers::pi / 8), 1e-3))
        EXPECT_NEAR((p - Point(1, 1)).norm(), std::sqrt(2.0), 2e-14);
}

TEST(Curve, AFlatBulgeKeepsItsDigits) {
    // Rise = bulge · half the chord.
    const auto points = bulgePoints({0, 0}, {100, 0}, 1e-12, 1e-14);
    for (const Point& p : points) EXPECT_LE(std::abs(p.y()), 5e-11 * (1 + 1e-12));
    EXPECT_EQ(bulgePoints({0, 0}, {1, 0}, 0.0, 1e-3).size(), 2U);
}

TEST(Curve, ABezierCurveIsASpline) {
    const Spline bezier{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {}};
    ASSERT_EQ(splineProblem(bezier), "");
    const auto points = splinePoints(bezier, 1e-5);
    EXPECT_EQ(points.front(), Point(0, 0));
    EXPECT_EQ(points.back(), Point(4, 0));
    double area = 0.0;  // under the curve: ∫ 6u·3(1 + 2u) dt with u = t(1 − t)
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        area += 0.5 * (points[i].y() + points[i + 1].y()) * (points[i + 1].x() - points[i].x());
    EXPECT_NEAR(area, 4.2, 1e-4);
}

TEST(Curve, WeightsMakeACircleOfASpline) {
    const double w = std::sqrt(0.5);
    const Spline quarter{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, w, 1}};
    ASSERT_EQ(splineProblem(quarter), "");
    for (const Point& p : splinePoints(quarter, 1e-4)) EXPECT_NEAR(p.norm(), 1.0, 1e-14);
}

TEST(Curve, SplinesOfSeveralSpansMeet) {
    const Spline spline{2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0}, {1, 0}, {2, 2}, {3, 2}}, {}};
    ASSERT_EQ(splineProblem(spline), "");
    bool middle = false;  // at the knot in the middle, half-way between the two inner control points
    for (const Point& p : splinePoints(spline, 1e-3)) middle = middle || (p - Point(1.5, 1)).norm() < 1e-14;
    EXPECT_TRUE(middle);
}

TEST(Curve, SplinesThatCannotBeDrawnSayWhy) {
    EXPECT_NE(splineProblem({3, {}, {}, {}}), "");
    EXPECT_NE(splineProblem({3, {0, 0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 2}, {3, 2}, {4, 0}}, {}}), "");
    EXPECT_NE(splineProblem({1, {0, 0, 0, 0}, {{0, 0}, {1, 1}}, {}}), "");
    EXPECT_NE(splineProblem({1, {0, 1, 0, 1}, {{0, 0}, {1, 1}}, {}}), "");
    EXPECT_NE(splineProblem({0, {0, 1}, {{0, 0}}, {}}), "");
    EXPECT_NE(splineProblem({1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1, -1}}), "");
    EXPECT_EQ(splineProblem({1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {}}), "");
}

}  // namespace
}  // namespace keyblock
