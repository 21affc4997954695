// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which blocks do not stand, and how a static search ends that shows neither rest
// nor a collapse.
#include "solver/run/run.h"

#include "solver/results/verdict.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace keyblock {
namespace {

/// A box `gap` m over a held floor.
Scene boxOverFloor(double gap) {
    Scene scene = test::boxOnBase(0.0, 30.0);
    scene.blocks[1] = boxBlock("box", {0, gap}, {1, 1 + gap});
    scene.stages = {test::settle()};
    return scene;
}

Verdict verdictOfRun(const Scene& scene, const Results& results) {
    const MemoryRun run(scene, results);
    return verdictOf(run.stages(), run.scene());
}

/// Half a metre of box reaches 0.707 m from its centre: a tenth of that is the boundary.
TEST(Stability, RestElsewhereIsDisplaced) {
    for (const double gap : {0.06, 0.09}) {
        const Scene scene = boxOverFloor(gap);
        const Results results = runInMemory(scene);
        const bool far = gap > 0.1 * std::sqrt(0.5);
        EXPECT_EQ(results.stages.at(0).outcome, far ? Outcome::Displaced : Outcome::Equilibrium) << gap;
        EXPECT_EQ(verdictOfRun(scene, results).stands, !far) << gap;
        if (!far) continue;
        ASSERT_EQ(results.stages[0].unstable.size(), 1U);
        const UnstableBlock& box = results.stages[0].unstable[0];
        EXPECT_EQ(box.block, 1);
        EXPECT_EQ(box.mode, Movement::Falls);
        EXPECT_NEAR(box.moved, gap, 1e-4);
        EXPECT_NEAR(box.weight, 2700.0 * gravity, 1.0);
    }
}

/// How far is a setting; null asks for no way at all.
TEST(Stability, HowFarABlockMayGoIsASetting) {
    Scene scene = boxOverFloor(0.3);
    scene.stages[0].until.move = std::nullopt;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Equilibrium);
    scene.stages[0].until.move = 0.5;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Equilibrium);
    scene.stages[0].until.move = 0.4;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Displaced);
}

/// A soft column settles under its weight by a sixth of a block at its top (Σ of ρgh/E over 8 m), but by a twentieth at
/// most from block to block.
TEST(Stability, SettlementOfASectionIsNone) {
    Scene scene = emptyScene(5e6, 0.0, 30.0);
    scene.analysis.penaltyRatio = 100.0;
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("floor", {-2, -1}, {3, 0})};
    for (int i = 0; i < 8; ++i) scene.blocks.push_back(boxBlock("", {0, 1.0 * i}, {1, i + 1.0}));
    Support held;
    held.blockAt = Point(0.5, -0.5);
    scene.supports = {held};
    scene.stages = {test::settle()};
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(0).outcome, Outcome::Equilibrium) << results.stages[0].message;
    EXPECT_LT(results.frames.back().blocks.back().displacement.y(), -0.12);
}

/// Nothing can stand on a frictionless slope; but three pseudo-steps do not show it.
TEST(Stability, ASearchWithoutAVerdictIsUndecided) {
    Scene scene = test::boxOnBase(20.0, 0.0);
    scene.stages = {test::settle(), test::settle()};
    for (const bool byStage : {true, false}) {
        Scene limited = scene;
        if (byStage) limited.stages[0].until.maxSteps = 3;
        else limited.limits.iterations = 3;
        const Results results = runInMemory(limited);
        ASSERT_EQ(results.stages.size(), 1U);
        EXPECT_EQ(results.stages[0].outcome, Outcome::Undecided);
        EXPECT_NE(results.stages[0].message.find("limits.iterations"), std::string::npos) << results.stages[0].message;
        EXPECT_EQ(verdictOfRun(limited, results).stands, std::nullopt);
    }
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Collapse);
}

/// A sliver hangs under a held roof; what lies on the floor stands without it.
TEST(Stability, WhatIsTooSmallToDecideIsLetGo) {
    Scene scene = boxOverFloor(0.0);
    scene.blocks.push_back(boxBlock("sliver", {3, 2}, {3.1, 2.05}));
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(0).outcome, Outcome::Equilibrium) << results.stages[0].message;
    EXPECT_EQ(results.stages[0].loose, std::vector<int>{2});
    EXPECT_EQ(verdictOfRun(scene, results).stands, true);
    EXPECT_LT(std::abs(results.stages[0].health.balanceError), 0.01);

    scene.stages[0].until.smallest = 0.0;
    const StageResult all = runInMemory(scene).stages.at(0);
    EXPECT_EQ(all.outcome, Outcome::Collapse);
    EXPECT_EQ(all.blocks, std::vector<int>{2});
}

/// Whatever rests on what slides goes with it.
TEST(Stability, ACollapseNamesWhatFollows) {
    Scene scene = test::boxOnBase(30.0, 10.0);
    scene.blocks.push_back(boxBlock("rider", {0.2, 1}, {0.8, 1.6}));
    scene.stages = {test::settle()};
    const StageResult stage = runInMemory(scene).stages.at(0);
    ASSERT_EQ(stage.outcome, Outcome::Collapse);
    ASSERT_EQ(stage.unstable.size(), 2U);
    for (const UnstableBlock& block : stage.unstable) EXPECT_GT(block.moved, 0.0);
    EXPECT_EQ(stage.unstable[0].mode, Movement::Slides);
}

/// What has moved in a collapse is named, though it has come to rest; what has hardly moved is not.
TEST(Stability, ACollapseNamesWhatHasMovedAndRests) {
    for (const double gap : {0.03, 0.06}) {  // a twentieth of the box's reach is 0.035 m
        Scene scene = boxOverFloor(gap);
        scene.blocks.push_back(boxBlock("falling", {20, 0}, {21, 1}));
        const StageResult stage = runInMemory(scene).stages.at(0);
        ASSERT_EQ(stage.outcome, Outcome::Collapse);
        ASSERT_EQ(stage.unstable.size(), gap > 0.05 ? 2U : 1U) << gap;
        EXPECT_EQ(stage.unstable[0].block, 2);
        EXPECT_EQ(stage.unstable[0].mode, Movement::Falls);
        if (gap < 0.05) continue;
        EXPECT_EQ(stage.unstable[1].block, 1);
        EXPECT_EQ(stage.unstable[1].mode, Movement::Follows);
        EXPECT_NEAR(stage.unstable[1].moved, gap, 1e-4);
    }
}

/// 25 MPa across a block of 240 N in a section of 80 m: under a penalty of 4,000 E round-off hides half of its weight.
TEST(Stability, RoundOffThatHidesAWeightIsUndecided) {
    Scene scene = emptyScene(50e9, 0.2, 45.0);
    scene.analysis.penaltyRatio = 4000.0;
    scene.analysis.gravity = {0.0, -gravity};
    scene.inSituStress.emplace().sxx = -25e6;
    scene.blocks = {boxBlock("left", {-40, 0}, {-0.05, 0.2}), boxBlock("key", {-0.05, 0.05}, {0.05, 0.15}),
                    boxBlock("right", {0.05, 0}, {40, 0.2})};
    for (const double x : {-30.0, 30.0}) {
        Support held;
        held.blockAt = Point(x, 0.1);
        scene.supports.push_back(held);
    }
    scene.stages = {test::settle()};
    scene.stages[0].until.smallest = 0.0;
    const StageResult hidden = runInMemory(scene).stages.at(0);
    EXPECT_EQ(hidden.outcome, Outcome::Undecided);
    EXPECT_NE(hidden.message.find("penalty ratio"), std::string::npos) << hidden.message;
    scene.analysis.penaltyRatio = 10.0;
    const StageResult seen = runInMemory(scene).stages.at(0);
    EXPECT_EQ(seen.outcome, Outcome::Equilibrium) << seen.message;
    EXPECT_LT(seen.health.worst.share, 0.02);
}

/// Slides for ever below its friction, comes to rest above, and falls where nothing is under it.
TEST(Stability, AMotionIsJudgedAtItsEnd) {
    struct Case {
        double angle, friction, speed;
        bool stands;
    };
    for (const Case& one : {Case{20.0, 10.0, 0.0, false}, Case{0.0, 30.0, 0.5, true}, Case{0.0, 0.0, 0.5, false}}) {
        Scene scene = test::boxOnBase(one.angle, one.friction);
        scene.stages = {test::dynamic(0.3, 1e-3)};
        InitialVelocity push;
        push.blockAt = Point(0.5, 0.5);
        push.velocity = {one.speed, 0.0};
        if (one.speed > 0.0) scene.stages[0].initialVelocities = {push};
        const Results results = runInMemory(scene);
        EXPECT_EQ(results.stages.at(0).outcome, Outcome::Duration);
        EXPECT_EQ(verdictOfRun(scene, results).stands, one.stands) << one.angle << " " << one.friction;
    }
    Scene scene = boxOverFloor(3.0);
    scene.stages = {test::dynamic(0.3, 1e-3)};
    const StageResult fall = runInMemory(scene).stages.at(0);
    ASSERT_EQ(fall.unstable.size(), 1U);
    EXPECT_EQ(fall.unstable[0].mode, Movement::Falls);
    EXPECT_NEAR(fall.unstable[0].moved, 0.5 * gravity * 0.09, 1e-3);
}

/// A box with 0.5 m/s slides 44 mm until friction of 30° stops it, after 88 ms; without friction it slides on.
TEST(Stability, AMotionThatGoesOnIsJudgedAtTheEndOfTheNextStage) {
    for (const double friction : {30.0, 0.0}) {
        Scene scene = test::boxOnBase(0.0, friction);
        InitialVelocity push;
        push.blockAt = Point(0.5, 0.5);
        push.velocity = {0.5, 0.0};
        scene.stages = {test::dynamic(0.01, 1e-3), test::dynamic(0.3, 1e-3)};
        scene.stages[0].initialVelocities = {push};
        const Results results = runInMemory(scene);
        ASSERT_EQ(results.stages.size(), 2U);
        EXPECT_TRUE(results.stages[0].unstable.empty()) << friction;
        EXPECT_EQ(verdictOfRun(scene, results).stands, friction > 0.0);
        scene.stages[1] = test::settle();  // without velocities: it cannot show where the box would have stopped
        const Results stopped = runInMemory(scene);
        EXPECT_EQ(stopped.stages.at(0).unstable.size(), friction > 0.0 ? 0U : 1U);
    }
}

/// A block at rest is not named because the block that it touches slides past it.
TEST(Stability, WhatAMovingBlockLeavesBehindIsAtRest) {
    Scene scene = test::boxOnBase(0.0, 0.0);
    scene.blocks.push_back(boxBlock("neighbour", {0, 1}, {0.5, 1.5}));
    InitialVelocity push;
    push.blockAt = Point(0.5, 0.5);
    push.velocity = {0.5, 0.0};
    scene.stages = {test::dynamic(0.3, 1e-3)};
    scene.stages[0].initialVelocities = {push};
    const StageResult stage = runInMemory(scene).stages.at(0);
    ASSERT_EQ(stage.unstable.size(), 1U);
    EXPECT_EQ(stage.unstable[0].block, 1);
}

/// What a motion drives goes where it is driven.
TEST(Stability, WhatIsDrivenIsExempt) {
    Scene scene = boxOverFloor(0.0);
    scene.blocks.push_back(boxBlock("rider", {0.2, 1}, {0.8, 1.6}));
    Motion motion;
    motion.blockAt = Point(0.5, 0.5);
    motion.table = {{0.0, 0.0}, {1.0, 0.5}};
    scene.stages[0].motions = {motion};
    scene.stages[0].increments = 20;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.at(0).outcome, Outcome::Equilibrium) << results.stages[0].message;
    EXPECT_NEAR(results.frames.back().blocks[1].displacement.x(), 0.5, 1e-3);
}

/// The first stage that fails to stand makes the run one that does not, whatever comes after.
TEST(Stability, OneStageDecides) {
    Scene scene = boxOverFloor(0.3);
    scene.stages.push_back(test::settle());
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2U);
    EXPECT_EQ(results.stages[1].outcome, Outcome::Equilibrium);
    const Verdict verdict = verdictOfRun(scene, results);
    EXPECT_EQ(verdict.stands, false);
    ASSERT_EQ(verdict.blocks.size(), 1U);
    EXPECT_EQ(verdict.blocks[0].stage, 0);
}

}  // namespace
}  // namespace keyblock
