// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rock that is taken out: what it gave to its walls is held and let go, by
// equilibrium alone in closed form.
#include "solver/run/run.h"

#include "solver/scene/preset.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using test::settle;

constexpr double lidWeight = 5.0 * 2700.0 * gravity;  // of the lid [N]

Stage excavating(const std::vector<std::string>& names, std::optional<double> relaxation) {
    Stage stage;
    stage.name = "excavate";
    stage.excavate = names;
    stage.relaxation = relaxation;
    stage.increments = 4;
    return stage;
}

/// A lid of 5 m × 1 m on three columns, the fixed base under them.
Scene columns() {
    Scene scene = emptyScene(1e10, 0.0, 30.0);
    scene.blocks = {boxBlock("base", {0, -1}, {5, 0}), boxBlock("left", {0, 0}, {1, 1}),
                    boxBlock("middle", {2, 0}, {3, 1}), boxBlock("right", {4, 0}, {5, 1}),
                    boxBlock("lid", {0, 1}, {5, 2})};
    Support support;
    support.blockAt = Point(2.5, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.materials[0].second.density = 2700.0;
    scene.output.every = 0.25;
    return scene;
}

/// Force between two blocks of a frame [N].
double forceBetween(const Frame& frame, int a, int b) {
    double force = 0.0;
    for (const ContactFrame& c : frame.contacts)
        if (std::minmax(c.blockA, c.blockB) == std::minmax(a, b)) force += c.normalForce;
    return force;
}

const Frame& frameAt(const Solved& solved, int stage, double time) {
    const auto& frames = solved.results.frames;
    const auto found = std::find_if(frames.rbegin(), frames.rend(), [&](const Frame& frame) {
        return frame.stage == stage && std::abs(frame.time - time) < 1e-9;
    });
    return found == frames.rend() ? frames.front() : *found;
}

/// The lid's weight rests on the two that stay and on what is still held of the middle one.
TEST(Excavation, WhatAColumnCarriedGoesOverToItsNeighboursEvenly) {
    Scene scene = columns();
    scene.stages = {settle(), excavating({"middle"}, std::nullopt)};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[1].outcome, Outcome::Equilibrium);
    const double before = forceBetween(frameAt(solved, 0, 1.0), 2, 4);
    ASSERT_GT(before, 0.2 * lidWeight);
    for (double time : {0.25, 0.5, 0.75, 1.0}) {
        const Frame& frame = frameAt(solved, 1, time);
        const double expected = 0.5 * (lidWeight - (1.0 - time) * before);
        EXPECT_NEAR(forceBetween(frame, 1, 4), expected, 1e-6 * lidWeight) << time;
        EXPECT_NEAR(forceBetween(frame, 3, 4), expected, 1e-6 * lidWeight) << time;
        EXPECT_EQ(frame.blocks[2].area, 0.0);
        EXPECT_TRUE(frame.blocks[2].points.empty());
        EXPECT_GT(frame.blocks[1].area, 0.0);
    }
    EXPECT_LT(std::abs(solved.results.stages[1].health.balanceError), 1e-6);
}

TEST(Excavation, WhatIsNotReleasedIsHeldUntilALaterStageReleasesIt) {
    Scene scene = columns();
    Stage held = settle(), dynamic = test::dynamic(0.1, 1e-3), rest = settle();
    held.name = "held";
    rest.name = "rest";
    rest.relaxation = 1.0;
    scene.stages = {settle(), excavating({"middle"}, 0.6), held, dynamic, rest};
    const Solved solved = solve(scene);
    const double before = forceBetween(frameAt(solved, 0, 1.0), 2, 4);
    const double partly = 0.5 * (lidWeight - 0.4 * before);
    EXPECT_NEAR(forceBetween(frameAt(solved, 1, 1.0), 1, 4), partly, 1e-6 * lidWeight);
    EXPECT_NEAR(forceBetween(frameAt(solved, 2, 1.0), 1, 4), partly, 1e-6 * lidWeight);
    const double moved =
        (frameAt(solved, 2, 1.0).blocks[4].centroid - frameAt(solved, 1, 1.0).blocks[4].centroid).norm();
    EXPECT_LT(moved, 1e-12);
    EXPECT_NEAR(forceBetween(frameAt(solved, 3, 0.1), 1, 4), partly, 1e-3 * lidWeight);
    EXPECT_NEAR(forceBetween(frameAt(solved, 4, 1.0), 1, 4), 0.5 * lidWeight, 1e-6 * lidWeight);
}

/// In motion, over a second: slow beside the lid on its columns, which swings by the force's rate over ω > 1000/s.
TEST(Excavation, ADynamicStageWithARelaxationReleasesEvenly) {
    Scene scene = columns();
    Stage slow = test::dynamic(1.0, 1e-3);
    slow.excavate = {"middle"};
    slow.relaxation = 1.0;
    scene.stages = {settle(), slow};
    const Solved solved = solve(scene);
    const double before = forceBetween(frameAt(solved, 0, 1.0), 2, 4);
    for (double time : {0.25, 0.5, 0.75, 1.0})
        EXPECT_NEAR(forceBetween(frameAt(solved, 1, time), 1, 4), 0.5 * (lidWeight - (1.0 - time) * before),
                    1e-3 * lidWeight)
            << time;
}

/// In motion it goes at once: a lid on nothing falls.
TEST(Excavation, InADynamicStageNothingIsHeld) {
    Scene scene = columns();
    Stage burst = test::dynamic(0.2, 1e-3);
    burst.excavate = {"left", "middle", "right"};
    scene.stages = {settle(), burst};
    const Solved solved = solve(scene);
    const Frame& last = solved.results.frames.back();
    EXPECT_NEAR(last.blocks[4].velocity.y(), -gravity * 0.2, 1e-9);
    EXPECT_LT(std::abs(solved.results.stages[1].health.balanceError), 1e-3);
}

/// Rock under stress, held above by two springs: the face goes down by its own strain and that of the springs.
TEST(Excavation, GroundReactionOfAFaceIsAStraightLine) {
    const double stress = 1e6, modulus = 1e10;
    Scene scene = emptyScene(modulus, 0.0, 30.0);
    scene.blocks = {boxBlock("below", {0, 0}, {1, 1}), boxBlock("above", {0, 1}, {1, 2})};
    for (const Point& point : {Point(0, 0), Point(1, 0), Point(0, 2), Point(1, 2)}) {
        Support support;
        support.point = point;
        support.fix = Fix::XY;
        scene.supports.push_back(support);
    }
    scene.inSituStress = InSituStress{0.0, -stress, 0.0, {}, 0.0};
    Monitor face;
    face.name = "face";
    face.point = Point(0.5, 1.0);
    scene.monitors = {face};
    scene.stages = {settle(), excavating({"below"}, 0.8), settle()};
    scene.stages[2].name = "rest";
    scene.stages[2].relaxation = 1.0;
    scene.stages[2].increments = 1;
    scene.output.every = 0.25;
    scene.monitors[0].point = Point(0.5, 1.5);
    const Solved solved = solve(scene);
    const double spring = 2.0 * numericsOf(scene.analysis).penaltyRatio * modulus;
    const double way = 0.5 * stress / modulus + stress / spring;  // of the block's middle, under all of the stress
    for (double time : {0.25, 0.5, 1.0}) {
        const Frame& frame = frameAt(solved, 1, time);
        EXPECT_NEAR(frame.blocks[1].displacement.y(), -0.8 * time * way, 1e-3 * way) << time;
        EXPECT_NEAR(frame.blocks[1].stress[1], -(1.0 - 0.8 * time) * stress, 1e-3 * stress) << time;
    }
    const Frame& last = solved.results.frames.back();
    EXPECT_NEAR(last.blocks[1].displacement.y(), -way, 1e-3 * way);
    EXPECT_NEAR(last.blocks[1].stress[1], 0.0, 1e-6 * stress);
    EXPECT_LT(std::abs(solved.results.stages[2].health.balanceError), 1e-6);
}

/// Nodes in the rock that goes keep the force it gave them until it is let go: N in the joint is that force.
TEST(Excavation, ABoltKeepsWhatTheRockGaveItUntilThatIsLetGo) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 84.78e6, std::nullopt, 0.0)};
    addBolt(scene, type, 0.05, 1.95, 19, PlateKind::Spring);
    scene.stages = {loadStage(scene, 100e3, 1), excavating({"right"}, 0.5), settle()};
    scene.stages[2].relaxation = 1.0;
    scene.output.every = 0.25;
    const Solved solved = solve(scene);
    const auto forceInJoint = [](const Frame& frame) { return frame.bolts[0].nodes[9].axialForce; };
    ASSERT_NEAR(forceInJoint(frameAt(solved, 0, 1.0)), 100e3, 1e-3 * 100e3);
    for (double time : {0.25, 0.5, 0.75, 1.0})
        EXPECT_NEAR(forceInJoint(frameAt(solved, 1, time)), (1.0 - 0.5 * time) * 100e3, 1.0) << time;
    EXPECT_NEAR(forceInJoint(solved.results.frames.back()), 0.0, 1.0);
    EXPECT_EQ(countOf(solved, EventKind::PulledOut), 0);
    EXPECT_EQ(frameAt(solved, 1, 1.0).bolts[0].nodes[15].block, -1);
    EXPECT_LT(std::abs(solved.results.stages[2].health.balanceError), 1e-6);
}

}  // namespace
}  // namespace keyblock
