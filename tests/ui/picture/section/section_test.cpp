// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A section of two bricks on a slab and a bolt through them, with numbers that can be
// checked by hand.
#include "ui/picture/section/section.h"

#include "solver/scene/solved_blocks.h"
#include "tests/ui/bricks.h"
#include "ui/picture/section/deformed.h"
#include "ui/picture/section/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using namespace test;

double lengthOf(const std::vector<LineShape>& lines) {
    double length = 0.0;
    for (const LineShape& line : lines) length += (line.to - line.from).norm();
    return length;
}

TEST(Section, FacesWithoutANeighbourAreWalls) {
    // Around the outside: 4 + 1 + (the slab's top from x = 3 on) 1 + 1 + 3 + 2; joints are not walls.
    EXPECT_NEAR(lengthOf(BricksRun().picture(0).walls), 4 + 1 + 1 + 1 + 3 + 2, 1e-9);
}

TEST(Section, AnExcavatedBlockLeavesWalls) {
    BricksRun run;
    run.results.frames[0].blocks[2] = BlockState{};  // the right brick was excavated
    const SectionPicture picture = run.picture(0);
    EXPECT_EQ(picture.blocks.size(), 2u);
    EXPECT_NEAR(lengthOf(picture.walls), 4 + 1 + 2 + 1 + 2 + 2, 1e-9);
}

TEST(Section, OneEdgeCanBePartJointPartWall) {
    const Scene scene = bricks();
    const SolvedBlocks solved = solvedBlocks(scene);
    const auto pieces = facePieces(scene, solved, cornersBefore(solved), {1, 1, 1});
    double joint = 0.0, wall = 0.0;
    for (const FacePiece& piece : pieces)
        if (piece.block == 0 && piece.edge == 2)
            (piece.kind == FaceKind::Joint ? joint : wall) += piece.to - piece.from;
    EXPECT_NEAR(joint, 0.75, 1e-9);
    EXPECT_NEAR(wall, 0.25, 1e-9);
}

TEST(Section, DisplacementsAreScaledByTheFactor) {
    const SectionPicture plain = BricksRun().picture(1), enlarged = BricksRun().picture(1, 20.0);
    EXPECT_NEAR(plain.blocks[1].outline[0].y(), 1.01, 1e-12);
    EXPECT_NEAR(enlarged.blocks[1].outline[0].y(), 1.2, 1e-12);
    EXPECT_NEAR(enlarged.blocks[1].before[0].y(), 1.0, 1e-12);
    EXPECT_NEAR(enlarged.blocks[1].displaced, 0.2, 1e-12);
    EXPECT_NEAR(enlarged.bolts[0].nodes[3].y(), 2.2, 1e-12);
    EXPECT_NEAR(enlarged.bolts[0].nodes[1].y(), 1.0, 1e-12);
    EXPECT_NE(enlarged.subtitle.find("displacements scaled by 20"), std::string::npos);
}

TEST(Section, ValuesAreShownInTheUnitsOfTheLegend) {
    const SectionPicture picture = BricksRun().picture(1);
    EXPECT_NEAR(*picture.blocks[1].value, 3.0, 1e-12);  // σ₁ of 3 MPa compression
    EXPECT_NEAR(*picture.blocks[2].value, 0.0, 1e-12);  // of 2 MPa tension along x
    EXPECT_NEAR(picture.bolts[0].values[1], 100.0, 1e-12);
    ASSERT_TRUE(picture.blockLegend && picture.boltLegend);
    EXPECT_EQ(picture.blockLegend->unit, "MPa");
    EXPECT_EQ(picture.boltLegend->unit, "kN per bolt");
    EXPECT_EQ(picture.blockLegend->range, (ValueRange{0.0, 3.0}));
    EXPECT_FALSE(picture.blockLegend->goesAbove);
}

TEST(Section, RangesAreThoseOfAllFrames) {
    const BricksRun run;
    EXPECT_EQ(run.picture(0).boltLegend->range, run.picture(1).boltLegend->range);
    EXPECT_EQ(run.picture(0).boltLegend->notes.back(), "this frame: 0.2 to 1.0 kN");
}

/// 1 mPa in rock of 50 GPa is round-off and does not extend the range; 1 kPa is a stress.
TEST(Section, RoundOffIsNotShownAsStress) {
    for (const double size : {1e-3, 1e3}) {
        BricksRun run;
        for (Frame& frame : run.results.frames)
            for (BlockState& block : frame.blocks) block.stress = {0.0, -size, 0.0};
        const LegendBar bar = *run.picture(1).blockLegend;
        EXPECT_EQ(bar.range.high, size < 1.0 ? 1.0 : 1e-3);
        EXPECT_FALSE(bar.goesBelow || bar.goesAbove);
    }
}

/// Blocks that have all fallen remain in the picture.
TEST(Section, TheExtentFollowsBlocksThatAllFell) {
    BricksRun run;
    for (BlockState& block : run.results.frames[1].blocks)
        for (Point& point : block.points) point.y() -= 30.0;
    EXPECT_LT(run.picture(1).model.min.y(), -29.0);
    for (Point& point : run.results.frames[1].blocks[0].points) point.y() += 30.0;  // the slab stays
    EXPECT_GT(run.picture(1).model.min.y(), -1.0);
}

TEST(Section, SteelLimitsAreMarkedOnTheLegend) {
    // 400 MPa on π/4·20² mm² is 125.7 kN: within half as much again of the largest force, so the bar reaches it.
    const SectionPicture picture = BricksRun().picture(1);
    ASSERT_FALSE(picture.boltLegend->limits.empty());
    EXPECT_NEAR(picture.boltLegend->limits[0].first, 125.66, 0.01);
    EXPECT_EQ(picture.boltLegend->limits[0].second, "yield");
    ASSERT_TRUE(picture.ribbon);
    EXPECT_EQ(picture.ribbon->peak, 1u);
    EXPECT_NEAR(*picture.ribbon->limit, 125.66, 0.01);
}

TEST(Section, AForceDiagramOfBondForcesHasTheLimitOfEachNode) {
    BricksRun bricks;
    auto& nodes = bricks.results.frames[1].bolts[0].nodes;
    const MemoryRun run(bricks.scene, bricks.results);
    SectionRequest request;
    request.frame = 1;
    request.bolts = findQuantity(boltQuantities(), "anchor_force");
    for (BoltNodeFrame& node : nodes) node.anchorForce = -8e3;
    EXPECT_FALSE(sectionPicture(run, request).ribbon->limit);
    nodes[0].bondStrength = 5e3;
    nodes[1].bondStrength = 12e3;
    const auto ribbon = sectionPicture(run, request).ribbon;
    ASSERT_TRUE(ribbon && ribbon->limit);
    EXPECT_NEAR(*ribbon->limit, 12.0, 1e-12);
    EXPECT_EQ(ribbon->limits, (std::vector<double>{5.0, 12.0, 0.0}));
    EXPECT_EQ(ribbon->scale, *ribbon->limit);
    nodes[1].bondStrength = 120e3;  // shown, however high
    EXPECT_NEAR(*sectionPicture(run, request).ribbon->limit, 120.0, 1e-12);
}

TEST(Arrows, CrossesShowBothPrincipalStressesInTheBlocks) {
    const BricksRun bricks;
    const std::vector<Point> places{{0, 0}, {1, 1}, {2, 2}};
    const ArrowField field = arrowField(ArrowKind::StressCrosses, bricks.results.frames[0], places);
    ASSERT_EQ(field.marks.size(), 6u);
    EXPECT_EQ(field.marks[2].shape, ArrowShape::Compression);  // 3 MPa upright in the left brick
    EXPECT_NEAR(std::abs(field.marks[2].value.y()), 3.0, 1e-12);
    EXPECT_EQ(field.marks[5].shape, ArrowShape::Tension);  // 2 MPa along x in the right one
    EXPECT_NEAR(std::abs(field.marks[5].value.x()), 2.0, 1e-12);
    EXPECT_DOUBLE_EQ(field.largest, 3.0);
}

TEST(Arrows, DisplacementsAreOfTheFrame) {
    const BricksRun bricks;
    const std::vector<Point> places(3, Point(0.0, 0.0));
    const ArrowField field = arrowField(ArrowKind::Displacements, bricks.results.frames[1], places);
    EXPECT_NEAR(field.marks[1].value.y(), 10.0, 1e-12);  // mm
    EXPECT_EQ(field.unit, "mm");
}

TEST(Section, RoundOffHasNoForceDiagram) {
    BricksRun bricks;
    for (BoltNodeFrame& node : bricks.results.frames[0].bolts[0].nodes) node.axialForce *= 1e-9;
    EXPECT_FALSE(bricks.picture(0).ribbon);
    EXPECT_TRUE(bricks.picture(1).ribbon);
}

TEST(Section, EventsUntilTheFrameAreGroupedAndNumbered) {
    const SectionPicture picture = BricksRun().picture(1);  // at 0.1 s
    ASSERT_EQ(picture.events.entries.size(), 1u);
    const EventEntry& entry = picture.events.entries[0];
    EXPECT_EQ(entry.number, 1);
    EXPECT_EQ(entry.subject, "B");
    EXPECT_EQ(entry.what, "2 elements yield");
    EXPECT_EQ(entry.count, 2);
    EXPECT_EQ(picture.events.counted, "2 joint slips");
    EXPECT_TRUE(BricksRun().picture(0).events.entries.empty());
}

TEST(Section, WithoutResultsNothingIsColoured) {
    const SectionPicture picture = BricksRun().picture(std::nullopt);
    EXPECT_FALSE(picture.blockLegend || picture.boltLegend || picture.ribbon);
    EXPECT_TRUE(picture.events.entries.empty());
    EXPECT_EQ(picture.blocks.size(), 3u);
    EXPECT_EQ(picture.bolts.size(), 1u);
    EXPECT_TRUE(picture.bolts[0].marks.empty());
    EXPECT_EQ(picture.title, "Bricks, before the run");
}

TEST(Section, TheLeastSevereEventsAreOmittedFirst) {
    BricksRun run;
    std::vector<Event> events;
    for (int bolt = 0; bolt < 1; ++bolt)
        for (const EventKind kind : {EventKind::Debonding, EventKind::Yield, EventKind::TensileRupture}) {
            Event event;
            event.kind = kind;
            event.bolt = bolt;
            events.push_back(event);
        }
    const EventList list = eventList(MemoryRun(run.scene, run.results), events, 2);
    ASSERT_EQ(list.entries.size(), 2u);
    EXPECT_EQ(list.leftOut, 1);
    EXPECT_EQ(list.entries[0].kind, EventKind::Yield);
    EXPECT_EQ(list.entries[1].number, 2);
}

}  // namespace
}  // namespace keyblock
