// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Profiles against the closed forms of their lengths, areas and normals, and the
// shapes that no tunnel has.
#include "geometry/shape/tunnel_profile.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"
#include "geometry/segment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

constexpr double pi = std::numbers::pi;

/// The area that an outline has left once its edges are close to the arcs.
double fineArea(const ProfileShape& shape) { return signedArea(outline(tunnelProfile(shape, 1e-9))); }

struct Case {
    std::string name;
    ProfileShape shape;
    double length = 0.0, area = 0.0;  // closed forms [m, m²]
    Point size{0.0, 0.0};  // of the bounding box [m]
};

const Point middle(3.0, -2.0);

std::vector<Case> cases() {
    const double w = 4.0, h = 4.5, depth = h - 0.5 * w, root = std::sqrt(w * w - depth * depth);
    const double turn = std::asin(depth / w), floor = 2.0 * root - w;
    // Arch of rise 1 over a chord of 4: radius 2.5, half-angle asin(0.8).
    const double half = std::asin(0.8);
    return {
        {"circle", CircleShape{middle, 5.0}, 5.0 * pi, 6.25 * pi, {5.0, 5.0}},
        {"d-shape", DShape{middle, 5.0, 5.5}, 5.0 + 2.0 * 3.0 + 2.5 * pi, 5.0 * 3.0 + 0.5 * 6.25 * pi, {5.0, 5.5}},
        {"half-circle", DShape{middle, 5.0, 2.5}, 5.0 + 2.5 * pi, 0.5 * 6.25 * pi, {5.0, 2.5}},
        {"horseshoe", HorseshoeShape{middle, w, h}, 0.5 * pi * w + 2.0 * w * turn + floor,
         pi * w * w / 8.0 + depth * root + w * w * turn - w * depth, {w, h}},
        {"half-circle as horseshoe", HorseshoeShape{middle, 5.0, 2.5}, 5.0 + 2.5 * pi, 0.5 * 6.25 * pi, {5.0, 2.5}},
        {"arched", ArchedShape{middle, 4.0, 3.0, 1.0}, 4.0 + 6.0 + 5.0 * half, 12.0 + 6.25 * half - 2.0 * 1.5,
         {4.0, 4.0}},
        {"arched without walls", ArchedShape{middle, 4.0, 0.0, 1.0}, 4.0 + 5.0 * half, 6.25 * half - 3.0, {4.0, 1.0}},
        {"polygon", PolygonShape{{{1, -4}, {1, 0}, {5, 0}, {5, -4}}}, 16.0, 16.0, {4.0, 4.0}},
    };
}

TEST(TunnelProfile, LengthsAndAreasAreThoseOfTheClosedForms) {
    for (const Case& c : cases()) {
        EXPECT_FALSE(profileProblem(c.shape)) << c.name;
        EXPECT_NEAR(tunnelProfile(c.shape).length, c.length, 1e-12 * c.length) << c.name;
        // The edges lie up to 1e-9 m off the arcs, or as far as 4096 of them to a circle do; two thirds on average.
        EXPECT_NEAR(fineArea(c.shape), c.area, 1e-6 * c.area) << c.name;
    }
}

TEST(TunnelProfile, TheCenterIsTheMiddleOfTheBoundingBox) {
    for (const Case& c : cases()) {
        const Box box = boxOf(outline(tunnelProfile(c.shape)));
        EXPECT_LT((0.5 * (box.min + box.max) - middle).norm(), 1e-14) << c.name;
        EXPECT_LT((box.max - box.min - c.size).norm(), 1e-14) << c.name;
    }
}

TEST(TunnelProfile, OutlinesAreSoundAndSymmetric) {
    for (const Case& c : cases()) {
        const std::vector<Point> corners = outline(tunnelProfile(c.shape));
        EXPECT_GT(signedArea(corners), 0.0) << c.name;
        EXPECT_FALSE(crossesItself(corners, 1e-9)) << c.name;
        for (const Point& p : corners) {
            const Point mirrored(2.0 * middle.x() - p.x(), p.y());
            double least = 1.0;
            for (const Point& q : corners) least = std::min(least, (q - mirrored).norm());
            EXPECT_LT(least, 1e-13) << c.name;
        }
    }
}

TEST(TunnelProfile, ACrownHasACornerInItsMiddle) {
    for (const Case& c : cases()) {
        if (c.name == "polygon") continue;
        double least = 1.0;
        for (const Point& p : outline(tunnelProfile(c.shape)))
            least = std::min(least, (p - middle - Point(0.0, 0.5 * c.size.y())).norm());
        EXPECT_LT(least, 1e-14) << c.name;
    }
}

TEST(TunnelProfile, ASagittaDecidesTheEdges) {
    const CircleShape circle{middle, 10.0};
    EXPECT_EQ(outline(tunnelProfile(circle)).size(), 32u);
    EXPECT_EQ(outline(tunnelProfile(circle, 100.0)).size(), 32u);
    EXPECT_EQ(outline(tunnelProfile(circle, 1e-30)).size(), 4096u);
    for (const double sagitta : {0.02, 0.005, 1e-4}) {
        const std::vector<Point> corners = outline(tunnelProfile(circle, sagitta));
        const double off = 5.0 - (0.5 * (corners[0] + corners[1]) - middle).norm();
        EXPECT_LE(off, sagitta);
        EXPECT_GT(off, 0.8 * sagitta) << "no more edges than it takes";
        for (const Point& p : corners) EXPECT_NEAR((p - middle).norm(), 5.0, 1e-14);
    }
}

TEST(TunnelProfile, HorseshoeArcsMeetSmoothlyAndReachTheFloor) {
    const TunnelProfile horseshoe = tunnelProfile(HorseshoeShape{middle, 4.0, 4.5});
    ASSERT_EQ(horseshoe.pieces.size(), 4u);
    EXPECT_EQ(horseshoe.pieces[1].arc->radius, 4.0);
    EXPECT_EQ(horseshoe.pieces[2].arc->radius, 2.0);
    for (const ProfilePiece& piece : horseshoe.pieces) {
        if (!piece.arc) continue;
        EXPECT_NEAR((piece.from - piece.arc->center).norm(), piece.arc->radius, 1e-14);
        EXPECT_NEAR((piece.to - piece.arc->center).norm(), piece.arc->radius, 1e-14);
    }
    const double floor = 2.0 * std::sqrt(16.0 - 6.25) - 4.0;
    EXPECT_NEAR(horseshoe.pieces[0].length, floor, 1e-14);
    const double spring = horseshoe.pieces[2].begin;
    for (const double off : {-1e-7, 0.0, 1e-7})
        EXPECT_LT((normalAtLength(horseshoe, spring + off) - Point(1, 0)).norm(), 1e-7);
}

TEST(WallPlaces, PointsAndNormalsFollowTheTrueWall) {
    const TunnelProfile d = tunnelProfile(DShape{{0, 0}, 5.0, 5.5});
    EXPECT_EQ(pointAtLength(d, 0.0), Point(-2.5, -2.75));
    EXPECT_EQ(pointAtLength(d, 2.5), Point(0.0, -2.75));
    EXPECT_EQ(normalAtLength(d, 2.5), Point(0, -1));
    EXPECT_EQ(normalAtLength(d, 6.5), Point(1, 0));
    const double crown = 8.0 + 1.25 * pi;
    EXPECT_LT((pointAtLength(d, crown) - Point(0, 2.75)).norm(), 1e-14);
    EXPECT_LT((normalAtLength(d, crown) - Point(0, 1)).norm(), 1e-14);
    const double seventh = 8.0 + 2.5 * pi / 7.0;
    EXPECT_LT((normalAtLength(d, seventh) - directionOf(180.0 / 7.0)).norm(), 1e-14);
    EXPECT_LT((pointAtLength(d, seventh) - Point(0, 0.25) - 2.5 * directionOf(180.0 / 7.0)).norm(), 1e-14);
    EXPECT_LT((pointAtLength(d, seventh - 3.0 * d.length) - pointAtLength(d, seventh)).norm(), 1e-12);
}

TEST(WallPlaces, AtACornerTheNormalIsHalfWay) {
    const TunnelProfile d = tunnelProfile(DShape{{0, 0}, 5.0, 5.5});
    const double half = std::sqrt(0.5);
    EXPECT_LT((normalAtLength(d, 5.0) - Point(half, -half)).norm(), 1e-14);
    EXPECT_LT((normalAtLength(d, 5.0 - 1e-12) - Point(half, -half)).norm(), 1e-14);
    EXPECT_LT((normalAtLength(d, 0.0) - Point(-half, -half)).norm(), 1e-14);
    EXPECT_EQ(normalAtLength(d, 5.0 - 1e-3), Point(0, -1));
}

TEST(WallPlaces, NearestAndPointAreInverse) {
    for (const Case& c : cases()) {
        const TunnelProfile profile = tunnelProfile(c.shape);
        for (int i = 0; i < 200; ++i) {
            const double length = profile.length * (i + 0.37) / 200.0;
            const Point wall = pointAtLength(profile, length);
            EXPECT_NEAR(lengthOfNearest(profile, wall), length, 1e-7) << c.name;  // flat in the distance: its root
            const Point rock = wall + 0.3 * normalAtLength(profile, length);
            EXPECT_NEAR(lengthOfNearest(profile, rock), length, 1e-12 * profile.length) << c.name;
            EXPECT_EQ(locate(outline(profile), rock, 1e-9), Side::Outside) << c.name;
        }
    }
}

TEST(WallPlaces, OutlinePointsLieOnThePolygonInLineWithTheTrueWall) {
    for (const Case& c : cases()) {
        const TunnelProfile profile = tunnelProfile(c.shape);
        const std::vector<Point> corners = outline(profile);
        for (int i = 0; i < 331; ++i) {
            const double length = profile.length * i / 331.0;
            const Point on = outlinePointAtLength(profile, length), wall = pointAtLength(profile, length);
            EXPECT_LT(distanceToBoundary(corners, on), 1e-14) << c.name;
            EXPECT_LT((wall - on).norm(), 0.005 * 4.0) << c.name;
            if ((wall - on).norm() > 1e-6) {
                EXPECT_NEAR(cross(normalAtLength(profile, length), wall - on), 0.0, 1e-14) << c.name;
            }
        }
        for (const ProfilePiece& piece : profile.pieces)
            for (int i = 0; i < piece.edges; ++i)
                EXPECT_EQ(outlinePointAtLength(profile, piece.begin + piece.length * i / piece.edges),
                          cornerOf(piece, i));
    }
}

TEST(WallPlaces, EquallyNearPlacesGiveTheFirst) {
    const TunnelProfile circle = tunnelProfile(CircleShape{{0, 0}, 2.0});
    EXPECT_EQ(lengthOfNearest(circle, {0, 0}), 0.0);
    const TunnelProfile square = tunnelProfile(PolygonShape{{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
    EXPECT_EQ(lengthOfNearest(square, {1, 1}), 1.0);
    EXPECT_EQ(lengthOfNearest(square, {-1, -1}), 0.0);
}

TEST(WallPlaces, LengthsBetweenAddUpToTheWholeRound) {
    const TunnelProfile circle = tunnelProfile(CircleShape{{0, 0}, 2.0});
    const double from = lengthOfNearest(circle, {3, 0}), to = lengthOfNearest(circle, {0, 3});
    EXPECT_NEAR(lengthBetween(circle, from, to, Way::CounterClockwise), 0.5 * pi, 1e-14);
    EXPECT_NEAR(lengthBetween(circle, from, to, Way::Clockwise), 1.5 * pi, 1e-14);
    EXPECT_EQ(lengthBetween(circle, from, from + 1e-12, Way::Clockwise), 0.0);
    EXPECT_EQ(lengthBetween(circle, from, from, Way::CounterClockwise), 0.0);
}

std::string faultOf(const ProfileShape& shape) {
    const auto problem = profileProblem(shape);
    return problem ? problem->field : "none";
}

TEST(ProfileProblem, NamesWhatMakesNoTunnel) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const Point o(0.0, 0.0);
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_EQ(faultOf(CircleShape{o, bad}), "diameter");
        EXPECT_EQ(faultOf(DShape{o, bad, 3.0}), "width");
        EXPECT_EQ(faultOf(HorseshoeShape{o, 3.0, bad}), "height");
        EXPECT_EQ(faultOf(ArchedShape{o, 3.0, 2.0, bad}), "rise");
    }
    EXPECT_EQ(faultOf(CircleShape{{nan, 0.0}, 1.0}), "center");
    EXPECT_EQ(faultOf(DShape{o, 5.0, 2.4999}), "height");
    EXPECT_EQ(faultOf(DShape{o, 5.0, 2.5}), "none");
    EXPECT_EQ(faultOf(ArchedShape{o, 4.0, -0.1, 1.0}), "wall_height");
    EXPECT_EQ(faultOf(ArchedShape{o, 4.0, 2.0, 2.0}), "none");
    EXPECT_EQ(faultOf(ArchedShape{o, 4.0, 2.0, 2.001}), "rise");
    EXPECT_EQ(faultOf(ArchedShape{o, 4.0, 2.0, 0.0039}), "rise");
    const TunnelProfile flat = tunnelProfile(ArchedShape{o, 4.0, 2.0, 0.004});
    const ProfilePiece& arch = flat.pieces[2];
    EXPECT_LT((pointAtLength(flat, arch.begin + 1e-12) - arch.from).norm(), 1e-11);
    EXPECT_LT((pointAtLength(flat, arch.begin + 0.5 * arch.length) - Point(0.0, 1.002)).norm(), 1e-12);
}

TEST(ProfileProblem, AHorseshoeIsAsHighAsItsWallsLetIt) {
    const Point o(0.0, 0.0);
    EXPECT_EQ(faultOf(HorseshoeShape{o, 4.0, 1.99}), "height");
    EXPECT_EQ(faultOf(HorseshoeShape{o, 4.0, 2.0}), "none");
    EXPECT_EQ(faultOf(HorseshoeShape{o, 4.0, 4.0 * 1.364}), "none");
    EXPECT_EQ(faultOf(HorseshoeShape{o, 4.0, 4.0 * 1.366}), "height");
    const TunnelProfile highest = tunnelProfile(HorseshoeShape{o, 4.0, 4.0 * 1.364});
    EXPECT_FALSE(crossesItself(outline(highest), 1e-9));
}

TEST(ProfileProblem, PolygonsMustBeOutlines) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(faultOf(PolygonShape{{}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{0, 0}, {1, 0}}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{0, 0}, {1, 0}, {nan, 1}}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{0, 0}, {1, 0}, {2, 0}}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{5, 5}, {5, 5}, {5, 5}}}), "points");
    EXPECT_EQ(faultOf(PolygonShape{{{0, 0}, {0, 1}, {1, 1}}}), "none");
}

}  // namespace
}  // namespace keyblock
