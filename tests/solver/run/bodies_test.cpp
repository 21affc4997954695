// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs with blocks beyond the scene's list: what is said of a block reaches its
// cells, and a plate that is a block is lost and left behind.
#include "solver/run/run.h"

#include "solver/results/tables.h"
#include "solver/scene/check.h"
#include "solver/scene/plate_place.h"
#include "solver/scene/solved_blocks.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using test::dynamic;

Block cut(Block block, double size) {
    block.subBlocks = CellSettings{size};
    return block;
}

int countOfBlock(const Solved& solved, EventKind kind) {
    return static_cast<int>(std::count_if(solved.results.events.begin(), solved.results.events.end(),
                                          [&](const Event& event) { return event.kind == kind; }));
}

TEST(SolvedBlocks, AreTheScenesThenPlates) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    scene.blocks[0].subBlocks = CellSettings{0.5};
    addBolt(scene, linearType(barArea(), 200e9), 0.1, 2.0, 10, PlateKind::Block);
    EXPECT_EQ(blockNames(scene),
              (std::vector<std::string>{"left:1", "left:2", "left:3", "left:4", "right", "B:plate"}));
    const SolvedBlocks solved = solvedBlocks(scene);
    EXPECT_EQ(solved.firstOf, (std::vector<int>{0, 4, 5}));
    EXPECT_EQ(solved.glued.size(), 4u);
    EXPECT_EQ(solved.blocks[5].block, 1);
}

TEST(PlatePlace, IsFlatOnTheFaceWhateverTheBoltsDirection) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    addBolt(scene, linearType(barArea(), 200e9), 0.1, 2.0, 10, PlateKind::Block);
    scene.bolts[0].farEnd = {0.3, 0.2};
    const PlatePlace place = placePlate(scene, scene.bolts[0]);
    ASSERT_EQ(place.fault, PlateFault::None);
    EXPECT_EQ(place.block, 1);
    EXPECT_NEAR(place.outward.x(), 1.0, 1e-12);
    EXPECT_NEAR(place.outline[0].x(), 2.0, 1e-12);
    EXPECT_NEAR(place.outline[2].x(), 2.01, 1e-12);
    EXPECT_NEAR(std::abs(place.outline[0].y() - place.outline[1].y()), 0.15, 1e-12);
    EXPECT_NEAR(place.overhang, 0.0, 1e-12);
}

TEST(PlatePlace, MayLieAcrossAJointAndTellsWhatNoFaceBacks) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("low", {0, 0}, {1, 0.5}), boxBlock("high", {0, 0.5}, {1, 1})};
    addBolt(scene, linearType(barArea(), 200e9), 0.1, 1.0, 10, PlateKind::Block);
    EXPECT_EQ(placePlate(scene, scene.bolts[0]).fault, PlateFault::None);  // head at the mouth of the joint
    EXPECT_NEAR(placePlate(scene, scene.bolts[0]).overhang, 0.0, 1e-12);
    scene.bolts[0].head = {1.0, 0.95};
    EXPECT_NEAR(placePlate(scene, scene.bolts[0]).overhang, 0.025, 1e-12);
}

/// Released in the air with a spin: every cell has the block's velocity there.
TEST(CellRuns, VelocitiesAreThoseOfTheWhole) {
    Scene scene = emptyScene(60e9, 0.2, 30.0);
    scene.blocks = {cut(boxBlock("block", {0, 0}, {1, 1}), 0.5)};
    scene.stages = {dynamic(0.1, 0.01)};
    InitialVelocity initial;
    initial.blockAt = {0.3, 0.3};
    initial.velocity = {2.0, 0.0};
    initial.spin = 1.0;
    scene.stages[0].initialVelocities = {initial};
    const Results results = solve(scene).results;
    ASSERT_FALSE(results.frames.empty());
    const Frame& last = results.frames.back();
    ASSERT_EQ(last.blocks.size(), 4u);
    Point middle(0.0, 0.0);
    for (const BlockState& block : last.blocks) {
        middle += 0.25 * block.displacement;
        EXPECT_NEAR(block.rotation, 0.1, 1e-5);
    }
    EXPECT_NEAR(middle.x(), 0.2, 1e-9);
    EXPECT_NEAR(middle.y(), 0.0, 1e-9);
}

TEST(CellRuns, ABlockThatFallsIsReportedOnce) {
    Scene scene = emptyScene(60e9, 0.2, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {cut(boxBlock("block", {0, 0}, {1, 1}), 0.25)};
    scene.stages = {dynamic(0.6, 0.01)};
    const Solved solved = solve(scene);
    EXPECT_EQ(countOfBlock(solved, EventKind::BlockFalls), 1);
    EXPECT_NEAR(solved.results.frames.back().blocks[7].displacement.y(), -0.5 * gravity * 0.36, 1e-6);
}

/// A column in cells on a fixed block: the weight of the whole reaches the base, stress rises with depth.
TEST(CellRuns, WeightPassesThroughCellsIntoTheBlockBelow) {
    Scene scene = emptyScene(10e9, 0.0, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("base", {-1, -1}, {2, 0}), cut(boxBlock("column", {0, 0}, {0.5, 2}), 0.5)};
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    Stage stage;
    stage.name = "settle";
    scene.stages = {stage};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.back().outcome, Outcome::Equilibrium) << solved.results.stages.back().message;
    const Frame& last = solved.results.frames.back();
    double carried = 0.0;
    for (const ContactFrame& contact : last.contacts) carried += contact.normalForce;
    EXPECT_NEAR(carried, 2700.0 * gravity * 1.0, 1e-6 * 2700.0 * gravity);
    ASSERT_EQ(last.blocks.size(), 5u);
    for (std::size_t row = 1; row < 5; ++row) {
        const double depth = 2.0 - last.blocks[row].centroid.y();
        EXPECT_NEAR(last.blocks[row].stress[1] / (-2700.0 * gravity * depth), 1.0, 1e-3);
    }
    EXPECT_LT(std::abs(solved.results.stages.back().health.balanceError), 1e-3);
}

/// v²/2μg on a base cut into cells: their inner edges and corners are no obstacles.
TEST(CellRuns, ABlockSlidesOverCellsAsOverOneFace) {
    const double speed = 3.0, friction = std::tan(20.0 * std::numbers::pi / 180.0);
    Scene scene = emptyScene(60e9, 0.25, 20.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {cut(boxBlock("base", {0, -1}, {4, 0}), 0.25), boxBlock("slider", {0.6, 0}, {1.1, 0.25})};
    Support support;
    support.blockAt = Point(2.1, -0.4);
    scene.supports = {support};
    scene.stages = {dynamic(1.0, 1e-3)};
    InitialVelocity initial;
    initial.blockAt = {0.8, 0.1};
    initial.velocity = {speed, 0.0};
    scene.stages[0].initialVelocities = {initial};
    const Solved solved = solve(scene);
    const BlockState& slider = solved.results.frames.back().blocks.back();
    EXPECT_NEAR(slider.displacement.x() / (speed * speed / (2.0 * friction * gravity)), 1.0, 5e-3);
    EXPECT_NEAR(slider.rotation, 0.0, 1e-6);
}

/// A force at the block's centroid is spread by mass: no cell is strained by it.
TEST(CellRuns, AForceOnTheWholeIsSpreadOverItsCells) {
    Scene scene = emptyScene(10e9, 0.0, 30.0);
    scene.blocks = {cut(boxBlock("block", {0, 0}, {2, 1}), 0.5)};
    Load load;
    load.blockAt = Point(0.1, 0.1);
    load.force = {5400.0, 0.0};
    scene.stages = {dynamic(0.1, 0.01)};
    scene.stages[0].loads = {load};
    const Results results = solve(scene).results;
    for (const BlockState& block : results.frames.back().blocks) {
        EXPECT_NEAR(block.displacement.x(), 0.5 * 0.1 * 0.1, 1e-9);
        EXPECT_NEAR(block.stress[0], 0.0, 1e-3);
    }
}

TEST(CellRuns, AMotionGripsTheCellItNames) {
    Scene scene = emptyScene(10e9, 0.0, 30.0);
    scene.blocks = {cut(boxBlock("bar", {0, 0}, {2, 0.5}), 0.5)};
    Stage stage;
    stage.name = "stretch";
    Motion left, right;
    left.blockAt = {0.25, 0.25};
    left.table = {{0.0, 0.0}, {1.0, 0.0}};
    right.blockAt = {1.75, 0.25};
    right.table = {{0.0, 0.0}, {1.0, 1.5e-4}};
    stage.motions = {left, right};
    stage.increments = 1;
    scene.stages = {stage};
    for (const Problem& problem : checkScene(scene)) EXPECT_NE(problem.severity, Severity::Error) << problem.message;
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.back().outcome, Outcome::Equilibrium) << solved.results.stages.back().message;
    // a gripped cell is pulled on one side only: half the stress, so its half counts as a quarter; and three glued edges
    const double way = 0.5 + 0.5 + 2.0 * 0.125 + 3.0 * 0.5 / 1000.0;
    const Frame& last = solved.results.frames.back();
    EXPECT_NEAR(last.blocks[1].stress[0] / (1.5e-4 / way * 10e9), 1.0, 1e-6);
    EXPECT_NEAR(last.blocks[0].stress[0] / last.blocks[1].stress[0], 0.5, 1e-6);
}

/// Glue is damped like the rock that it stands for: the links of its drag belong to no bolt.
TEST(CellRuns, CellsAreDampedWithoutAnyBolt) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {cut(boxBlock("block", {0, 0}, {2, 1}), 0.5)};
    scene.analysis.damping.stiffness = 1e-3;
    scene.blocks[0].initialStress = {1e6, 0.0, 0.0};
    scene.stages = {dynamic(0.02, 1e-4)};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.back().outcome, Outcome::Duration) << solved.results.stages.back().message;
    const Energy& energy = solved.results.frames.back().energy;
    EXPECT_LT(energy.kinetic + energy.strain, 1e-3 * energy.damped);
    EXPECT_NEAR(energy.balanceError, 0.0, 1e-6);
}

TEST(PlateRuns, ALostPlateStaysAsALooseBlock) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9)};
    type.plate.normalStrength = 20e3;
    addBolt(scene, type, 0.1, 2.0, 10, PlateKind::Block);
    scene.stages = {pullStage(scene, 2e-3, 10)};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.back().outcome, Outcome::Equilibrium) << solved.results.stages.back().message;
    ASSERT_EQ(countOfBlock(solved, EventKind::PlateLoss), 1);
    for (const Event& event : solved.results.events)
        if (event.kind == EventKind::PlateLoss) {
            EXPECT_NEAR(event.axialForce, 20e3, 2.0);
            EXPECT_EQ(event.block, 2);
        }
    EXPECT_NEAR(reading(solved, "last B.plate_force"), 0.0, 1e-9);
    EXPECT_FALSE(solved.results.frames.back().bolts[0].plateHolds);
    EXPECT_EQ(solved.results.frames.back().blocks.size(), 3u);
}

/// Two bolts in a model of 1 m, one every half metre: the plate's force is that of one bolt.
TEST(PlateRuns, ForcesArePerBolt) {
    Scene scene = elasticRebar(20e6, rigidRock);
    scene.bolts[0].plate = PlateKind::Block;
    const double one = reading(solve(scene), "last B.plate_force");
    scene.bolts[0].spacingOutOfPlane = 0.5;
    scene.stages = {loadStage(scene, 400e3, 4)};
    EXPECT_NEAR(reading(solve(scene), "last B.plate_force") / one, 1.0, 1e-3);
}

}  // namespace
}  // namespace keyblock
