// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing of a section as offices make them, with layers, arcs, splines, blocks
// and text, becomes a scene that cuts into blocks whose areas are known.
#include "geometry/polygon.h"
#include "solver/files/drawing/dxf_file.h"
#include "solver/files/drawing/section_import.h"
#include "tests/solver/files/drawing/drawing_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using test::DrawingText;
constexpr double pi = std::numbers::pi;

void layers(DrawingText& d, const std::vector<std::string>& names) {
    d.section("TABLES").pair(0, "TABLE").pair(2, "LAYER").pair(70, static_cast<int>(names.size()));
    for (const std::string& name : names)
        d.pair(0, "LAYER").pair(2, name).pair(70, 0).pair(62, 7).pair(6, "CONTINUOUS");
    d.pair(0, "ENDTAB").end();
}

/// A bolt 2.4 m long with its plate, head at the origin, upwards.
void boltBlock(DrawingText& d) {
    d.section("BLOCKS").pair(0, "BLOCK").pair(8, "0").pair(2, "ROCKBOLT").pair(70, 0).at(10, {0, 0});
    d.line("0", {0, 0}, {0, 2400});
    d.entity("SOLID", "0").at(10, {-75, 0}).at(11, {75, 0}).at(12, {-75, -10}).at(13, {75, -10});
    d.pair(0, "ENDBLK").pair(8, "0").end();
}

/// 30 m × 27 m in millimetres, a D-shaped drift 5 m wide and 5.5 m high, a fault that is an arc from side to side, a
/// bedding plane that is a spline, seven straight joints, three bolts round the crown, and what else offices draw.
std::string section() {
    DrawingText d;
    d.units(4);
    layers(d, {"0", "MODEL_BOUNDARY", "TUNNEL-WALL", "JOINTS-J1", "FAULTS", "BEDDING", "ROCKBOLTS", "TEXT", "DIM"});
    boltBlock(d);
    d.section("ENTITIES");
    d.polyline("MODEL_BOUNDARY", {{-15000, -12000}, {15000, -12000}, {15000, 15000}, {-15000, 15000}});
    d.line("TUNNEL-WALL", {-2500, 250}, {-2500, -2750}).line("TUNNEL-WALL", {-2500, -2750}, {2500, -2750});
    d.line("TUNNEL-WALL", {2500, -2750}, {2500, 250}).arc("TUNNEL-WALL", {0, 250}, 2500, 0, 180);
    const double reach = std::acos(15.0 / 25.0) * 180.0 / pi;  // from side to side, 20 m over its centre
    d.arc("FAULTS", {0, -12500}, 25000, reach, 180.0 - reach);
    d.entity("SPLINE", "BEDDING").pair(70, 8).pair(71, 3).pair(72, 8).pair(73, 4).pair(74, 0);
    for (const double knot : {0, 0, 0, 0, 1, 1, 1, 1}) d.pair(40, knot);
    for (const Point& p : std::vector<Point>{{-15000, -6000}, {-5000, -5000}, {5000, -8000}, {15000, -6000}})
        d.at(10, p).pair(30, 0.0);
    for (const double angle : {-45.0, 0.0, 45.0}) {
        const double up = (90.0 + angle) * pi / 180.0;
        d.entity("INSERT", "ROCKBOLTS").pair(2, "rockbolt");
        d.at(10, {2500 * std::cos(up), 250 + 2500 * std::sin(up)}).pair(50, angle);
    }
    d.entity("TEXT", "TEXT").at(10, {0, 0}).pair(40, 250.0).pair(1, "SECTION A-A");
    d.entity("MTEXT", "TEXT").at(10, {0, 0}).pair(40, 250.0).pair(1, "\\A1;granite, RMR 65");
    d.entity("DIMENSION", "DIM").pair(2, "*D7").at(10, {0, -3000});
    return d.end().text();
}

Import import(const std::string& text, double sagitta) {
    return importSection(readDxf(text, sagitta * 1000.0), {}, "section.dxf");
}

/// Area of the block that holds a point, or of all that are left.
double areaAt(const Import& import, const Point& place) {
    for (const Block& block : import.cut->scene.blocks)
        if (locate(block.points, place, 1e-9) == Side::Inside) return std::abs(signedArea(block.points));
    return 0.0;
}

TEST(ImportSection, BecomesASceneThatCutsIntoKnownAreas) {
    for (const double sagitta : {0.01, 1e-3, 1e-4}) {
        const Import read = import(section(), sagitta);
        ASSERT_TRUE(read.scene) << oneLine(read.problems.front());
        EXPECT_EQ(read.scene->joints.size(), 2U);
        EXPECT_EQ(read.scene->tunnels.size(), 1U);
        EXPECT_EQ(read.scene->bolts.size(), 3U);
        ASSERT_EQ(read.cut->blocks, 4);  // rock round the drift is parted in two, as no block has a hole
        // Under the spline y = -6 + 3t(1-t)²·1 - 3t²(1-t)·2 over x = -15 + 30t (m); between it and the arc, less the drift;
        // over the arc of radius 25 about (0, -12.5), half-chord 15, whose segment has r²(α - sin α cos α).
        const double bedding = 30.0 * (6.0 + 0.25 - 0.5);
        const double half = std::asin(15.0 / 25.0);
        const double fault = 30.0 * (7.5 + 12.0) + 625.0 * (half - std::sin(half) * std::cos(half));
        const double drift = 5.0 * 3.0 + 0.5 * pi * 6.25;
        // Chords cut off at most two thirds of sagitta × length of the curves: 31 m, 33 m and 8 m of them.
        EXPECT_NEAR(areaAt(read, {-14, -11}), bedding, 0.67 * sagitta * 31.0);
        EXPECT_NEAR(areaAt(read, {0, 14}), 810.0 - fault, 0.67 * sagitta * 33.0);
        EXPECT_NEAR(read.cut->area, 810.0 - drift, 0.67 * sagitta * 8.0);
    }
}

TEST(ImportSection, AccountsForEveryEntity) {
    const Import read = import(section(), 0.01);
    const auto count = [&](const std::string& kind, const std::string& layer, const std::string& became) {
        for (const ImportRow& row : read.rows)
            if (row.kind == kind && row.layer == layer && row.became == became) return row.count;
        return 0;
    };
    EXPECT_EQ(count("LWPOLYLINE", "MODEL_BOUNDARY", "boundary of the domain"), 1);
    EXPECT_EQ(count("LINE", "TUNNEL-WALL", "outline of a tunnel"), 3);
    EXPECT_EQ(count("ARC", "TUNNEL-WALL", "outline of a tunnel"), 1);
    EXPECT_EQ(count("ARC", "FAULTS", "joint"), 1);
    EXPECT_EQ(count("SPLINE", "BEDDING", "joint"), 1);
    EXPECT_EQ(count("INSERT", "ROCKBOLTS", "block 'ROCKBOLT', inserted"), 3);
    EXPECT_EQ(count("LINE in block 'ROCKBOLT'", "ROCKBOLTS", "bolt"), 3);
    EXPECT_EQ(count("SOLID in block 'ROCKBOLT'", "ROCKBOLTS", "skipped"), 3);
    EXPECT_EQ(count("TEXT", "TEXT", "skipped"), 1);
    EXPECT_EQ(count("MTEXT", "TEXT", "skipped"), 1);
    EXPECT_EQ(count("DIMENSION", "DIM", "skipped"), 1);
    int all = 0;
    for (const ImportRow& row : read.rows) all += row.count;
    EXPECT_EQ(all, 1 + 4 + 1 + 1 + 3 + 6 + 3);
    EXPECT_EQ(read.notTaken.size(), 6U);
    for (const NotTaken& item : read.notTaken) EXPECT_GT(item.place.line, 0);
}

TEST(ImportSection, PutsHeadsOfBoltsOnTheWall) {
    const Import read = import(section(), 1e-3);
    for (const Bolt& bolt : read.scene->bolts) {
        EXPECT_NEAR((bolt.head - Point(0, 0.25)).norm(), 2.5, 1e-12);
        EXPECT_NEAR((bolt.farEnd - Point(0, 0.25)).norm(), 4.9, 1e-12);
        EXPECT_EQ(bolt.type, "assumed-bolt");
    }
}

TEST(ImportSection, SaysWhatWasAssumed) {
    const Import read = import(section(), 0.01);
    ASSERT_EQ(read.scene->materials.size(), 1U);
    EXPECT_EQ(read.scene->materials[0].first, "assumed-rock");
    EXPECT_EQ(read.scene->jointMaterials[0].first, "assumed-joint");
    for (const std::string word : {"assumed-rock", "gravity", "nearer to a tunnel", "assumed-bolt"})
        EXPECT_TRUE(std::any_of(read.assumed.begin(), read.assumed.end(), [&](const std::string& text) {
            return text.find(word) != std::string::npos;
        })) << word;
}

TEST(ImportSection, IsReadBackTheSame) {
    const Import read = import(section(), 0.01);
    const SceneReading again = readSceneText(sceneText(*read.scene), "again");
    ASSERT_TRUE(again.scene);
    EXPECT_EQ(*again.scene, *read.scene);
}

/// Circles stay round under turning and even scaling, and become ellipses under uneven.
TEST(ImportSection, CirclesInBlocksStayRoundWhereTheyAre) {
    for (const double stretch : {1.0, 2.0}) {
        DrawingText d;
        d.units(6).section("BLOCKS").pair(0, "BLOCK").pair(2, "RING").at(10, {0, 0});
        d.entity("CIRCLE", "0").at(10, {1, 0}).pair(40, 1.0);
        d.pair(0, "ENDBLK").end().section("ENTITIES");
        d.polyline("boundary", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
        d.entity("INSERT", "tunnel").pair(2, "RING").at(10, {0, 0});
        d.pair(41, 2.0).pair(42, 2.0 * stretch).pair(50, 30.0);
        const Import read = importSection(readDxf(d.end().text(), 1e-4), {}, "rings.dxf");
        ASSERT_TRUE(read.scene);
        const SceneTunnel& tunnel = read.scene->tunnels[0];
        EXPECT_EQ(tunnel.profile, stretch == 1.0 ? ProfileKind::Circle : ProfileKind::Polygon);
        if (stretch == 1.0) {
            EXPECT_EQ(tunnel.diameter, 4.0);
            EXPECT_NEAR((tunnel.center - 2.0 * Point(std::sqrt(0.75), 0.5)).norm(), 0.0, 1e-15 * 4);
        } else {
            EXPECT_NEAR(std::abs(signedArea(tunnel.points)), pi * 2.0 * 4.0, 1e-4 * 20.0);
        }
    }
}

TEST(ImportSection, EllipsesAndTheirArcsAreDrawn) {
    DrawingText d;
    d.units(6).section("ENTITIES").polyline("boundary", {{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
    d.entity("ELLIPSE", "tunnel").at(10, {1, 2}).at(11, {3, 4}).pair(40, 0.4).pair(41, 0.0).pair(42, 2.0 * pi);
    d.entity("ELLIPSE", "joints").at(10, {0, -20}).at(11, {20, 0}).pair(40, 0.5).pair(41, 0.0).pair(42, pi);
    const Import read = importSection(readDxf(d.end().text(), 1e-4), {}, "ellipses.dxf");
    ASSERT_TRUE(read.scene);
    EXPECT_NEAR(std::abs(signedArea(read.scene->tunnels[0].points)), pi * 5.0 * 2.0, 1e-4 * 25.0);
    EXPECT_NEAR(areaAt(read, {0, -19}), 0.5 * pi * 20.0 * 10.0, 1e-4 * 50.0);
}

}  // namespace
}  // namespace keyblock
