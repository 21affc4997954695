// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Patterns round profiles where arithmetic says how many bolts stand where.
#include "geometry/shape/bolt_pattern.h"

#include "geometry/angle.h"
#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

const TunnelProfile circularTunnel = tunnelProfile(CircleShape{{0, 0}, 4.0});
const TunnelProfile drift = tunnelProfile(DShape{{0, 0}, 5.0, 5.5});

BoltPattern pattern(const Point& from, const Point& to, double spacing) {
    BoltPattern p;
    p.from = from;
    p.to = to;
    p.spacing = spacing;
    p.length = 2.4;
    return p;
}

TEST(BoltPattern, StandsAtEqualLengthsFromEndToEnd) {
    // Half a circle of radius 2: 2π, in sixths.
    const auto bolts = layOut(circularTunnel, pattern({2, 0}, {-2, 0}, std::numbers::pi / 3.0));
    ASSERT_EQ(bolts.size(), 7u);
    for (std::size_t i = 0; i < bolts.size(); ++i) {
        const Point out = directionOf(30.0 * static_cast<double>(i));
        EXPECT_NEAR(cross(out, bolts[i].head), 0.0, 1e-14);
        EXPECT_LT((bolts[i].farEnd - bolts[i].head - 2.4 * out).norm(), 1e-14);
        EXPECT_LE(bolts[i].head.norm(), 2.0 + 1e-14);
        EXPECT_GE(bolts[i].head.norm(), 2.0 * std::cos(std::numbers::pi / 32.0) - 1e-14) << "on an edge of the polygon";
        EXPECT_NEAR(bolts[i].fromBeginning, std::numbers::pi / 3.0 * static_cast<double>(i), 1e-14);
    }
    EXPECT_EQ(bolts.front().head, Point(2, 0));
    EXPECT_LT((bolts[3].head - Point(0, 2)).norm(), 1e-14);
}

TEST(BoltPattern, TheOtherWayRoundIsTheMirrorImage) {
    BoltPattern up = pattern({2.5, 0}, {-2.5, 0}, 0.8), down = pattern({-2.5, 0}, {2.5, 0}, 0.8);
    down.way = Way::Clockwise;
    up.offset = down.offset = 0.3;
    up.angleFromWall = down.angleFromWall = 70.0;
    const auto a = layOut(drift, up), b = layOut(drift, down);
    // 0.25 of wall on either side, and the crown.
    ASSERT_EQ(a.size(), static_cast<std::size_t>((0.5 + 2.5 * std::numbers::pi - 0.3) / 0.8) + 1u);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_LT((Point(-a[i].head.x(), a[i].head.y()) - b[i].head).norm(), 1e-13);
        EXPECT_LT((Point(-a[i].farEnd.x(), a[i].farEnd.y()) - b[i].farEnd).norm(), 1e-13);
    }
    EXPECT_EQ(layOut(drift, pattern({2.5, 0}, {-2.5, 0}, 100.0)).front().head, Point(2.5, 0));
    down.way = Way::CounterClockwise;  // now down the left wall, along the floor and up the right one
    EXPECT_NEAR(boltCount(drift, down), std::floor((2.75 + 5.0 + 2.75 - 0.3) / 0.8) + 1.0, 0.0);
}

TEST(BoltPattern, LeansForwardBelowARightAngle) {
    BoltPattern p = pattern({-2.5, -2.75}, {2.5, -2.75}, 2.5);  // along the floor, to the right
    p.angleFromWall = 60.0;
    p.offset = 1.0;
    const auto bolts = layOut(drift, p);
    ASSERT_EQ(bolts.size(), 2u);
    EXPECT_LT((bolts[0].head - Point(-1.5, -2.75)).norm(), 1e-14);
    EXPECT_LT((bolts[0].farEnd - bolts[0].head - 2.4 * Point(0.5, -std::sqrt(0.75))).norm(), 1e-14);
    std::swap(p.from, p.to);
    p.way = Way::Clockwise;
    EXPECT_LT((layOut(drift, p)[0].farEnd - Point(1.5, -2.75) - 2.4 * Point(-0.5, -std::sqrt(0.75))).norm(), 1e-14);
}

TEST(BoltPattern, TheEndCountsInSpiteOfRoundOff) {
    for (int parts = 1; parts <= 60; ++parts)
        EXPECT_EQ(boltCount(circularTunnel, pattern({2, 0}, {0, 2}, std::numbers::pi / parts)), parts + 1) << parts;
    EXPECT_EQ(boltCount(circularTunnel, pattern({2, 0}, {0, 2}, std::numbers::pi * 1.0000001)), 1.0);
}

TEST(BoltPattern, FromAPlaceToItselfIsTheWholeWayRound) {
    for (const Way way : {Way::CounterClockwise, Way::Clockwise}) {
        BoltPattern p = pattern({0, 9}, {0, 5}, 4.0 * std::numbers::pi / 12.0);
        p.way = way;
        const auto ring = layOut(circularTunnel, p);
        ASSERT_EQ(ring.size(), 12u);
        for (std::size_t i = 0; i < ring.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) EXPECT_GT((ring[i].head - ring[j].head).norm(), 1.0);
        p.offset = 1e-12;
        EXPECT_EQ(boltCount(circularTunnel, p), 12.0);
        p.offset = 2.0 * std::numbers::pi;
        EXPECT_EQ(boltCount(circularTunnel, p), 7.0);
    }
}

TEST(BoltPattern, OneBoltWhereTheSpacingIsLongerNoneBeyondTheEnd) {
    BoltPattern p = pattern({2, 0}, {0, 2}, 10.0);
    ASSERT_EQ(layOut(circularTunnel, p).size(), 1u);
    p.offset = 3.0;
    EXPECT_EQ(layOut(circularTunnel, p).size(), 1u);
    p.offset = 3.2;  // the part is π long
    EXPECT_TRUE(layOut(circularTunnel, p).empty());
    p.to = p.from;
    p.offset = 12.6;  // the whole is 4π
    EXPECT_TRUE(layOut(circularTunnel, p).empty());
}

TEST(BoltPattern, BoltsLeaveThePolygonAtEveryAllowedAngle) {
    for (const TunnelProfile* profile : {&circularTunnel, &drift})
        for (const double angle : {leastAngleFromWall, 45.0, 90.0, greatestAngleFromWall}) {
            BoltPattern p = pattern({0, 9}, {0, 9}, 0.07);
            p.angleFromWall = angle;
            const std::vector<Point> wall = outline(*profile);
            for (const PatternBolt& bolt : layOut(*profile, p)) {
                EXPECT_EQ(locate(wall, bolt.head, 1e-12), Side::Boundary);
                EXPECT_EQ(locate(wall, bolt.head + 0.01 * (bolt.farEnd - bolt.head), 1e-12), Side::Outside);
                EXPECT_EQ(locate(wall, bolt.farEnd, 1e-12), Side::Outside);
                EXPECT_NEAR((bolt.farEnd - bolt.head).norm(), 2.4, 1e-14);
            }
        }
}

TEST(BoltPattern, ProblemsNameTheField) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    const auto field = [](auto change) {
        BoltPattern p = pattern({2, 0}, {0, 2}, 1.0);
        change(p);
        const auto problem = boltPatternProblem(p);
        return problem ? problem->field : std::string("none");
    };
    EXPECT_EQ(field([](BoltPattern&) {}), "none");
    for (const double bad : {0.0, -1.0, nan, infinity}) {
        EXPECT_EQ(field([&](BoltPattern& p) { p.spacing = bad; }), "spacing");
        EXPECT_EQ(field([&](BoltPattern& p) { p.length = bad; }), "length");
    }
    for (const double bad : {-1.0, nan, infinity}) EXPECT_EQ(field([&](BoltPattern& p) { p.offset = bad; }), "offset");
    for (const double bad : {9.9, 170.1, nan})
        EXPECT_EQ(field([&](BoltPattern& p) { p.angleFromWall = bad; }), "angle_from_wall");
    EXPECT_EQ(field([&](BoltPattern& p) { p.from.x() = nan; }), "from");
    EXPECT_EQ(field([&](BoltPattern& p) { p.to.y() = infinity; }), "to");
    EXPECT_GT(boltCount(circularTunnel, pattern({2, 0}, {0, 2}, 1e-9)), 1e9);
}

}  // namespace
}  // namespace keyblock
