// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A static stage is at equilibrium only where every block is, whatever else presses
// in the scene; and where one falls, the stage says so.
#include "solver/run/run.h"

#include "solver/files/scene/scene_file.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace keyblock {
namespace {

/// A wedge 1 m wide in the roof of a section `size` m wide, all held but the wedge, under 5 MPa across.
Scene roofWedge(double halfAngle, double frictionAngle, double size) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    const Point apex(0.0, 0.5 / std::tan(halfAngle * degree));
    const double left = -0.5 * size, right = 0.5 * size, top = size;
    scene.blocks = {boxBlock("left", {}, {}), boxBlock("right", {}, {}), boxBlock("wedge", {}, {})};
    scene.blocks[0].points = {{left, 0.0}, {-0.5, 0.0}, apex, {0.0, top}, {left, top}};
    scene.blocks[1].points = {{0.5, 0.0}, {right, 0.0}, {right, top}, {0.0, top}, apex};
    scene.blocks[2].points = {{-0.5, 0.0}, {0.5, 0.0}, apex};
    for (const double x : {0.9 * left, 0.9 * right}) {
        Support held;
        held.blockAt = Point(x, 0.5);
        scene.supports.push_back(held);
    }
    scene.inSituStress.emplace().sxx = -5e6;
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {test::settle()};
    return scene;
}

TEST(Equilibrium, AWedgeUnderStressFallsWhereItsFacesAreSteeperThanFriction) {
    for (const double size : {15.0, 40.0}) {
        const StageResult stage = runInMemory(roofWedge(34.0, 5.0, size)).stages.at(0);
        EXPECT_EQ(stage.outcome, Outcome::Collapse) << size;
        EXPECT_EQ(stage.blocks, std::vector<int>{2}) << size;
        EXPECT_LT(std::abs(stage.health.balanceError), 0.01) << size;
    }
}

/// The weight, shared by both faces, is all that changes along them.
TEST(Equilibrium, AWedgeUnderStressHoldsWhereFrictionIsSteeper) {
    const Solved solved = solve(roofWedge(5.0, 30.0, 15.0));
    EXPECT_EQ(solved.results.stages.at(0).outcome, Outcome::Equilibrium);
    double up = 0.0;
    for (const ContactFrame& c : solved.results.frames.back().contacts) {
        const Point along(std::sin(5.0 * degree), std::cos(5.0 * degree));
        up += std::abs(c.shearForce) * along.y() - std::abs(c.normalForce) * along.x();
    }
    const double weight = 2700.0 * gravity * 0.25 / std::tan(5.0 * degree);
    EXPECT_NEAR(up, weight, 2e-3 * weight);
}

/// The weight of what is held is no measure for what slides on it.
TEST(Equilibrium, ABlockSlidesOnALongSlopeWithoutFriction) {
    Scene scene = test::boxOnBase(45.0, 0.0);
    scene.blocks = {boxBlock("base", {-350, -100}, {350, 0}), boxBlock("box", {0, 0}, {0.5, 0.25})};
    scene.stages = {test::settle()};
    const StageResult stage = runInMemory(scene).stages.at(0);
    EXPECT_EQ(stage.outcome, Outcome::Collapse);
    EXPECT_EQ(stage.blocks, std::vector<int>{1});
}

/// What a user allows on a block is what is left on it at most.
TEST(Equilibrium, WhatMayBeLeftOnABlockIsASetting) {
    Scene scene = test::boxOnBase(0.0, 30.0);
    scene.stages = {test::settle()};
    scene.stages[0].until.unbalanced = 0.1;
    for (const double body : {1e-1, 1e-3, 1e-6}) {
        scene.stages[0].until.body = body;
        const Solved solved = solve(scene);
        double thrust = 0.0;
        for (const ContactFrame& c : solved.results.frames.back().contacts) thrust += c.normalForce;
        const double weight = 2700.0 * gravity;
        EXPECT_NEAR(thrust, weight, body * weight);
    }
}

/// A box 1 m wide that reaches 0.2 m over the end of a held floor, and perhaps a held wall behind it.
Scene boxOverEdge(bool wall) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.analysis.tolerance = 1e-4;
    scene.blocks = {boxBlock("box", {0, 0}, {1, 1}), boxBlock("floor", {-1, -1}, {0.8, 0})};
    if (wall) scene.blocks.push_back(boxBlock("wall", {-1, 0}, {0, 1}));
    for (const Point& at : {Point(0.0, -0.5), Point(-0.5, 0.5)}) {
        Support held;
        held.blockAt = at;
        if (wall || at.y() < 0.0) scene.supports.push_back(held);
    }
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {test::settle(), test::settle()};
    scene.stages[1].name = "drive";
    return scene;
}

/// Pushed at its centre, with friction under it, it tips over the edge, but never into the floor.
TEST(Equilibrium, ABoxThatIsDrivenOverAnEdgeStaysOutOfTheFloor) {
    Scene scene = boxOverEdge(false);
    Motion motion;
    motion.blockAt = Point(0.5, 0.5);
    motion.table = {{0.0, 0.0}, {1.0, 0.25}};
    motion.rotation = Rotation::Free;
    scene.stages[1].motions = {motion};
    scene.stages[1].increments = 20;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(1).outcome, Outcome::Equilibrium);
    EXPECT_LT(std::abs(results.stages[1].health.balanceError), 0.01);
    for (const Frame& frame : results.frames) EXPECT_GT(frame.blocks[0].centroid.y(), 0.499) << frame.time;
}

/// However long the increments are, the wall pushes the box by as much as its joint opens.
TEST(Equilibrium, ADilationKeepsTheEnergyOnAWayOfAnyLength) {
    for (const int increments : {5, 20}) {
        Scene scene = boxOverEdge(true);
        scene.jointMaterials.emplace_back("jack", scene.jointMaterials[0].second);
        scene.jointMaterials[1].second.frictionAngle = 0.0;
        scene.blocks[2].jointMaterial = "jack";
        scene.stages[1].dilations = {Dilation{"jack", 0.25}};
        scene.stages[1].increments = increments;
        const Results results = runInMemory(scene);
        EXPECT_EQ(results.stages.at(1).outcome, Outcome::Equilibrium) << increments;
        EXPECT_LT(std::abs(results.stages[1].health.balanceError), 1e-3) << increments;
        EXPECT_NEAR(results.frames.back().blocks[0].displacement.x(), 0.25, 1e-4) << increments;
    }
}

/// What falls by less than its own size may come to rest elsewhere; the size of a cell is none.
TEST(Equilibrium, ABlockOfCellsMayFallFurtherThanACell) {
    Scene scene = test::boxOnBase(0.0, 30.0);
    scene.blocks[1] = boxBlock("box", {0, 0.3}, {1, 1.3});
    scene.blocks[1].subBlocks = CellSettings{0.25};
    scene.stages = {test::settle()};
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(0).outcome, Outcome::Displaced);
    EXPECT_NEAR(results.frames.back().blocks[1].displacement.y(), -0.3, 1e-4);
}

/// A box that is pushed slides at W·tan φ; that is found to 0.02 of the load.
TEST(Equilibrium, ALimitLoadIsFoundWithoutIncrements) {
    Scene scene = test::boxOnBase(0.0, 30.0);
    const double limit = 2700.0 * gravity * std::tan(30.0 * degree);
    Load load;
    load.blockAt = Point(0.5, 0.5);
    load.at = Point(0.0, 0.1);
    load.force = {1.2 * limit, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    scene.stages = {test::settle(), test::settle()};
    scene.stages[1].name = "push";
    scene.stages[1].loads = {load};
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(1).outcome, Outcome::Collapse);
    EXPECT_NEAR(results.stages[1].time, 1.0 / 1.2, 0.02);
}

StageResult staticRunOf(const char* file) {
    const SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_TEST_DATA_DIR) / "safety" / file);
    if (!reading.scene) throw std::runtime_error(file);
    return runInMemory(*reading.scene).stages.at(0);
}

bool falls(const StageResult& stage) {
    return stage.outcome == Outcome::Displaced || stage.outcome == Outcome::Collapse;
}

/// The friction of the joint is 8 % too small to hold the block. It slides with hardly any resistance, so that an error
/// of the solution moves it in each pseudo-step. When GMRES ended at a tenth of the force that a step may leave on each
/// body, there was no verdict after 20,000 pseudo-steps.
TEST(Equilibrium, ABlockThatHardlySlidesIsDecided) {
    const StageResult stage = staticRunOf("overhanging-block.json");
    EXPECT_TRUE(falls(stage)) << stage.message;
    EXPECT_LE(stage.health.steps, 2000);
}

/// The friction of the joint is within 0.2 % of what holds the block, so either verdict will do. When pseudo-steps after
/// a swing could at once be as long as before it, the block changed between three positions for 20,000 pseudo-steps.
TEST(Equilibrium, ABlockNearItsLimitIsDecided) {
    const StageResult stage = staticRunOf("overhanging-block-near-its-limit.json");
    EXPECT_NE(stage.outcome, Outcome::Undecided) << stage.message;
    EXPECT_LE(stage.health.steps, 2000);
}

}  // namespace
}  // namespace keyblock
