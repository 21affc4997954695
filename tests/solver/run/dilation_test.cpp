// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints that are driven apart against what holds them: the same as if the rock
// beside them were drawn away by as much.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

constexpr double opened = 0.5e-3;  // [m]

/// Two blocks of rigid rock and an elastic bolt across their joint.
Scene bolted() {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 84.78e6, std::nullopt, 0.0)};
    addBolt(scene, type, 0.05, 1.95, 19, PlateKind::Spring);
    scene.materials[0].second.density = 2700.0;
    return scene;
}

double forceInJoint(const Frame& frame) { return frame.bolts[0].nodes[9].axialForce; }

/// What the bolt carries when the right block is drawn off by the same way.
double drawn() {
    Scene scene = bolted();
    scene.stages = {pullStage(scene, opened, 1)};
    return forceInJoint(solve(scene).results.frames.back());
}

Dilation dilation(const Scene& scene, double rate) { return {scene.jointMaterials[0].first, rate}; }

TEST(Dilation, AStaticStageOpensTheJointAgainstTheBolt) {
    for (ContactMethod method : {ContactMethod::Penalty, ContactMethod::AugmentedLagrangian}) {
        Scene scene = bolted();
        scene.analysis.contact = method;
        Stage stage = test::settle(), rest = test::settle();
        stage.dilations = {dilation(scene, opened)};
        stage.increments = 4;
        rest.name = "rest";
        scene.stages = {stage, rest};
        const Solved solved = solve(scene);
        ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
        const double expected = drawn();
        ASSERT_GT(expected, 1e4);
        EXPECT_NEAR(forceInJoint(solved.results.frames.back()), expected, 1e-4 * expected);
        EXPECT_NEAR(reading(solved, "last opening"), opened, 1e-4 * opened);
        const Energy& energy = solved.results.frames.back().energy;
        EXPECT_LT(std::abs(energy.balanceError), 1e-6);
        EXPECT_NEAR(energy.external, energy.bolt, 1e-3 * energy.bolt);  // the work of the joint is what the bolt stores
    }
}

TEST(Dilation, ADynamicStageOpensTheJointAtItsRate) {
    Scene scene = bolted();
    scene.materials[0].second.youngsModulus = 60e9;
    const double duration = 0.5;
    Stage stage = test::dynamic(duration, 1e-3);
    stage.dilations = {dilation(scene, opened / duration)};
    scene.stages = {stage};
    const Solved solved = solve(scene);
    const double expected = drawn();
    EXPECT_NEAR(forceInJoint(solved.results.frames.back()), expected, 2e-2 * expected);
    EXPECT_LT(std::abs(solved.results.stages[0].health.balanceError), 1e-3);
}

/// Two stages open further than one; rates of different stages add up.
TEST(Dilation, WhatOneStageOpenedStaysForTheNext) {
    Scene scene = bolted();
    Stage first = test::settle(), second = test::settle();
    first.dilations = {dilation(scene, 0.4 * opened)};
    first.increments = 2;
    second = first;
    second.name = "more";
    second.dilations[0].rate = 0.6 * opened;
    scene.stages = {first, second};
    const Solved solved = solve(scene);
    EXPECT_NEAR(forceInJoint(solved.results.frames.back()), drawn(), 1e-4 * drawn());
}

}  // namespace
}  // namespace keyblock
