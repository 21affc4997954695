// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic stages through the whole run: rest, falls, slides, bonds that let go
// in motion, the change from one kind of stage to the other, and their energy.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

using test::box;
using test::boxOnBase;
using test::dynamic;
using test::lastOf;
using test::settle;
using test::weight;

void expectEnergyBalance(const Results& results, double error = 1e-3) {
    for (const StageResult& stage : results.stages) {
        EXPECT_NE(stage.outcome, Outcome::Failed) << stage.message;
        EXPECT_LT(std::abs(stage.health.balanceError), error) << "stage " << stage.stage;
    }
    for (const Frame& frame : results.frames) EXPECT_LT(std::abs(frame.energy.balanceError), error) << frame.time;
}

TEST(Dynamics, ABlockAtRestStaysThere) {
    Scene scene = boxOnBase(0.0, 30.0);
    scene.stages = {dynamic(1.0, 1e-3)};
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages[0].steps, 1000);
    EXPECT_LT(box(results).displacement.norm(), 1e-14);
    EXPECT_LT(box(results).velocity.norm(), 1e-11);
    EXPECT_TRUE(results.events.empty());
}

/// However far the joints give under the load that they take up before the first step.
TEST(Dynamics, SoftAndTallStacksStayToo) {
    for (const double modulus : {1e7, 10e9}) {
        Scene scene = boxOnBase(0.0, 30.0);
        scene.materials[0].second.youngsModulus = modulus;
        for (int i = 1; i < 30; ++i) scene.blocks.push_back(boxBlock("", {0, i}, {1, i + 1.0}));
        scene.stages = {dynamic(0.05, 1e-3)};
        const Results results = runInMemory(scene);
        for (const BlockState& block : results.frames.back().blocks) EXPECT_LT(block.displacement.norm(), 1e-9);
    }
}

/// Joints that carry already stay as they are where others, without any force yet, are given theirs.
TEST(Dynamics, ASettledPairOfStacksDoesNotBounce) {
    Scene scene = boxOnBase(0.0, 30.0);
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
        scene.blocks.push_back(boxBlock("", {x, y}, {x + 1.0, y + 1.0}));
    Stage motion = dynamic(0.05, 1e-3);
    motion.zeroDisplacements = true;
    scene.stages = {settle(), motion};
    const Results results = runInMemory(scene);
    for (const BlockState& block : results.frames.back().blocks) EXPECT_LT(block.displacement.norm(), 1e-10);
    expectEnergyBalance(results);
}

TEST(Dynamics, BackwardEulerRestsToo) {
    Scene scene = boxOnBase(20.0, 30.0);
    scene.stages = {dynamic(0.2, 1e-3)};
    scene.stages[0].integration = Integration::BackwardEuler;
    const Results results = runInMemory(scene);
    EXPECT_LT(box(results).displacement.norm(), 1e-9);
    expectEnergyBalance(results);
}

TEST(Dynamics, ASettledBlockDoesNotBounce) {
    Scene scene = boxOnBase(10.0, 30.0);
    Stage motion = dynamic(0.2, 1e-3);
    motion.zeroDisplacements = true;
    scene.stages = {settle(), motion};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2u);
    EXPECT_LT(box(results).displacement.norm(), 1e-12);
    EXPECT_LT(box(results).velocity.norm(), 1e-9);
    expectEnergyBalance(results);
}

TEST(Dynamics, ZeroGravityIsPeace) {
    Scene scene = boxOnBase(0.0, 30.0);
    scene.analysis.gravity = {0.0, 0.0};
    scene.stages = {dynamic(0.1, 1e-3)};
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Duration);
    EXPECT_EQ(box(results).displacement, Point(0.0, 0.0));
    EXPECT_EQ(box(results).velocity, Point(0.0, 0.0));
}

/// The corners of cells meet only to within round-off; the forces of such overlaps must not be solved for.
TEST(Dynamics, CellsWithoutLoadsNeedNoSolution) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.analysis.gravity = {0.0, 0.0};
    scene.domain = SceneDomain{{{-6, -6}, {6, -6}, {6, 6}, {-6, 6}}, scene.materials.front().first, {}};
    scene.voronoi.emplace().size = 1.0;
    scene.stages = {dynamic(1e-3, 1e-3)};
    const Results results = runInMemory(scene);
    ASSERT_GT(results.frames.back().blocks.size(), 100u);
    for (const BlockState& block : results.frames.back().blocks) EXPECT_LT(block.displacement.norm(), 1e-14);
    EXPECT_EQ(results.stages[0].health.work.solves, 0);
}

/// An overlap within the geometric tolerance does not push blocks apart.
TEST(Dynamics, BlocksWithASmallOverlapStayAtRest) {
    Scene scene = boxOnBase(0.0, 30.0);
    scene.analysis.gravity = {0.0, 0.0};
    for (Point& corner : scene.blocks.back().points) corner.y() -= 1e-10;
    scene.stages = {dynamic(0.01, 1e-3)};
    const Results results = runInMemory(scene);
    EXPECT_LT(box(results).velocity.norm(), 1e-9);
}

TEST(Dynamics, FreeFallTurnsWorkIntoMotion) {
    Scene scene = boxOnBase(0.0, 30.0);
    for (Point& p : scene.blocks[1].points) p.y() += 20.0;
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler}) {
        scene.stages = {dynamic(0.5, 1e-3)};
        scene.stages[0].integration = scheme;
        const Results results = runInMemory(scene);
        const Energy& energy = results.frames.back().energy;
        EXPECT_NEAR(energy.kinetic, 0.5 * 2700.0 * std::pow(0.5 * gravity, 2), 1e-6 * energy.kinetic);
        expectEnergyBalance(results, 1e-9);
    }
}

TEST(Dynamics, SlidingTurnsWorkIntoFriction) {
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler}) {
        Scene scene = boxOnBase(40.0, 20.0);
        scene.stages = {dynamic(0.5, 1e-3)};
        scene.stages[0].integration = scheme;
        const Results results = runInMemory(scene);
        const double slid = box(results).displacement.x();
        const double a = gravity * (std::sin(40 * degree) - std::cos(40 * degree) * std::tan(20 * degree));
        EXPECT_NEAR(slid, 0.5 * a * 0.25, 5e-3 * slid);
        const double friction = weight * std::cos(40 * degree) * std::tan(20 * degree) * slid;
        EXPECT_NEAR(results.frames.back().energy.friction, friction, 5e-3 * friction);
        expectEnergyBalance(results);
    }
}

TEST(Dynamics, AKnockLosesEnergyButNeverGains) {
    Scene scene = boxOnBase(0.0, 30.0);
    for (Point& p : scene.blocks[1].points) p.y() += 0.01;
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler}) {
        scene.stages = {dynamic(0.2, 1e-4)};
        scene.stages[0].integration = scheme;
        const Results results = runInMemory(scene);
        for (const Frame& frame : results.frames) {
            const Energy& e = frame.energy;
            EXPECT_LE(e.kinetic + e.strain + e.contact, e.external + 1e-6 * weight * 0.01);
            EXPECT_GE(e.damped, -1e-9 * weight);
        }
        expectEnergyBalance(results, 1e-2);
    }
}

/// Motion that a static stage takes away is booked.
TEST(Dynamics, AStaticStageBooksTheMotionItEnds) {
    Scene scene = boxOnBase(40.0, 20.0);
    JointMaterial rough;
    rough.frictionAngle = 60.0;
    scene.jointMaterials.emplace_back("rough", rough);
    scene.stages = {dynamic(0.2, 1e-3), settle()};
    scene.stages[0].initialVelocities.resize(1);
    scene.stages[0].initialVelocities[0].blockAt = {0.5, 0.5};
    scene.stages[0].initialVelocities[0].velocity = {1.0, 0.0};
    scene.analysis.gravity = {0.0, -gravity};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2u);
    EXPECT_EQ(results.stages[1].outcome, Outcome::Equilibrium) << results.stages[1].message;
    EXPECT_EQ(results.frames.back().energy.kinetic, 0.0);
    expectEnergyBalance(results);
}

/// A block hung on one bar from rest swings to twice its weight; a bond of less strength lets go on the way.
Scene hung(double strength) {
    Scene scene = emptyScene(rigidRock, 0.2, 0.0);
    scene.blocks = {boxBlock("left", {0, 0}, {1, 1}), boxBlock("right", {1.1, 0}, {2.1, 1})};
    Support support;
    support.blockAt = Point(0.5, 0.1);
    scene.supports = {support};
    scene.analysis.gravity = {gravity, 0.0};
    BoltType bar = linearType(barArea(), 200e9);
    bar.bending = Bending::None;
    Anchor weak = anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e8, strength, 5e3);
    weak.at = BoltPlace{false, 0.0};
    bar.anchors = {weak, anchorAt(1.5, AnchorLaw::Elastic, 1e9)};
    addBolt(scene, bar, 0.3, 1.8, 15, PlateKind::None);
    scene.monitors.clear();
    scene.stages = {dynamic(0.03, 1e-4)};
    scene.output.frames = 30;
    return scene;
}

TEST(Dynamics, ABondLetsGoAtItsStrength) {
    const Results results = runInMemory(hung(40e3));
    const auto event = std::find_if(results.events.begin(), results.events.end(),
                                    [](const Event& e) { return e.kind == EventKind::Debonding; });
    ASSERT_NE(event, results.events.end());
    EXPECT_EQ(event->node, 0);
    EXPECT_NEAR(std::abs(event->anchorForce), 40e3, 1e-4 * 40e3);
    expectEnergyBalance(results);
}

/// Eight bars support the block. The bonds of the four weakest fail one after the other within a few steps. An event is
/// located to 1e-4 of the strength or to a thousandth of the time step.
TEST(Dynamics, BondsAreLocatedInAFewTries) {
    Scene scene = hung(5e3);
    const BoltType type = scene.boltTypes[0];
    const Bolt bar = scene.bolts[0];
    for (int i = 1; i < 8; ++i) {
        BoltType& more = scene.boltTypes.emplace_back(type);
        more.name += std::to_string(i);
        more.anchors[0].strength = 5e3 + 1e3 * i;
        Bolt& other = scene.bolts.emplace_back(bar);
        other.name += std::to_string(i);
        other.type = more.name;
        other.farEnd.y() += 0.05 * i, other.head.y() += 0.05 * i;
    }
    scene.stages[0].timeStep = 1e-3;
    const Results results = runInMemory(scene);
    long failed = 0;
    for (const Event& event : results.events) {
        if (event.kind != EventKind::Debonding) continue;
        ++failed;
        const double strength = *scene.boltTypes[event.bolt].anchors[0].strength;
        EXPECT_NEAR(std::abs(event.anchorForce), strength, 1e-3 * strength) << event.bolt;
    }
    EXPECT_EQ(failed, 4);
    const StageResult& stage = results.stages[0];
    EXPECT_LE(stage.health.steps - stage.steps, 3 * failed);
}

TEST(Dynamics, ABondStrongerThanTheSwingHolds) {
    const Results results = runInMemory(hung(2.1 * weight));
    EXPECT_TRUE(results.events.empty());
    expectEnergyBalance(results);
}

/// A soft block rebounds from the base. The next stage begins while it is compressed, and two other blocks touch without
/// any force.
TEST(Dynamics, AMotionThatTheNextStageContinuesKeepsItsForces) {
    Scene scene = boxOnBase(0.0, 30.0);
    scene.materials[0].second.youngsModulus = 1e6;
    scene.analysis.gravity = {0.0, 0.0};
    for (const double x : {4.0, 5.0}) scene.blocks.push_back(boxBlock("", {x, 0}, {x + 1.0, 1}));
    const auto motionIn = [&](const std::vector<double>& durations) {
        scene.stages.clear();
        for (const double duration : durations) {
            scene.stages.push_back(dynamic(duration, 5e-4));
            scene.stages.back().integration = Integration::Newmark;
        }
        InitialVelocity down;
        down.blockAt = Point(0.5, 0.5);
        down.velocity = Point(0.0, -0.1);
        scene.stages[0].initialVelocities = {down};
        return runInMemory(scene);
    };
    const Results whole = motionIn({0.15}), divided = motionIn({0.05, 0.1});
    EXPECT_LT(lastOf(divided, 0).blocks[1].displacement.y(), -1e-3);
    EXPECT_GT(box(whole).displacement.y(), 5e-3);
    EXPECT_NEAR(box(divided).displacement.y(), box(whole).displacement.y(), 1e-9);
}

TEST(Dynamics, ALostBoltLeavesNothingBehind) {
    Scene scene = hung(40e3);
    scene.boltTypes[0].anchors[0].onFailure = OnFailure::BoltLost;
    const Results results = runInMemory(scene);
    EXPECT_TRUE(results.frames.back().bolts[0].lost);
    const double speed = box(results).velocity.x();
    EXPECT_NEAR(results.frames.back().energy.kinetic, 0.5 * 2700.0 * speed * speed, 1e-6 * 2700.0 * speed * speed);
    expectEnergyBalance(results);
}

/// Cohesion that lets go in motion: the books know what it held.
TEST(Dynamics, AJointThatLetsGoKeepsTheBooks) {
    Scene scene = boxOnBase(40.0, 20.0);
    scene.jointMaterials[0].second.cohesion = 5e3;
    scene.stages = {dynamic(0.1, 1e-3)};
    const Results results = runInMemory(scene);
    EXPECT_FALSE(results.events.empty());
    EXPECT_GT(results.frames.back().energy.released, 0.0);
    expectEnergyBalance(results);
}

}  // namespace
}  // namespace keyblock
