// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much work a step in motion takes, counted and never timed: a wall of 1,053
// blocks at rest, walls of 266 and 1,053 that slide and topple, the smaller of them also
// with bolts, a field of 974 cells with a hole dug into it, and the drift without bolts.
// No step is cut.
#include "solver/files/scene/bolt_library.h"
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace keyblock {
namespace {

constexpr const char* cells = R"({
  "format": "keyblock-scene", "version": 1,
  "analysis": {"gravity": [0, -9.81], "penalty_ratio": 40},
  "materials": {"stone": {"density": 2500, "youngs_modulus": 10e9, "poissons_ratio": 0.2}},
  "joint_materials": {"joint": {"friction_angle": 30}},
  "domain": {"boundary": [[-16, -16], [16, -16], [16, 16], [-16, 16]], "material": "stone", "joint_material": "joint"},
  "voronoi": {"size": 1, "seed": 1, "joint_material": "joint"},
  "tunnels": [{"name": "hole", "profile": "circle", "center": [0, 0], "diameter": 8}],
  "blocks": [
    {"name": "floor", "points": [[-18, -18], [18, -18], [18, -16], [-18, -16]], "material": "stone", "joint_material": "joint"},
    {"name": "west", "points": [[-18, -16], [-16, -16], [-16, 16], [-18, 16]], "material": "stone", "joint_material": "joint"},
    {"name": "east", "points": [[16, -16], [18, -16], [18, 16], [16, 16]], "material": "stone", "joint_material": "joint"}
  ],
  "supports": [{"block_at": [0, -17], "fix": "all"}, {"block_at": [-17, 0], "fix": "all"}, {"block_at": [17, 0], "fix": "all"}],
  "stages": [{"name": "settle", "kind": "static"},
             {"name": "dig", "kind": "dynamic", "duration": 0.09, "time_step": 0.001, "excavate": ["hole"]}],
  "output": {"frames": 1}
})";

Health healthAfter(Scene scene, double duration) {
    scene.stages.back().duration = duration;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.back().outcome, Outcome::Duration) << results.stages.back().message;
    return results.stages.back().health;
}

/// Mean work and factorizations of a solve, of the search for first forces too.
void expectWork(const Health& health, double mostWork, double mostFactorizations) {
    EXPECT_EQ(health.stepCuts, 0);
    EXPECT_EQ(health.energyCuts, 0);
    const double solves = static_cast<double>(health.steps);
    EXPECT_GE(solves, 50.0);
    EXPECT_LE(workOf(health.work) / solves, mostWork);
    EXPECT_LE(static_cast<double>(health.work.factorizations) / solves, mostFactorizations);
}

/// If motion follows, a static stage leaves 0.03 of the unbalanced force that it may leave on a block. With ten times as
/// much the wall sways.
TEST(StepWork, TallWallThatHasSettledStartsAtRest) {
    Scene wall = settledWall(10, 40, 0.05);
    wall.analysis.modelEverything = true;
    const Results results = runInMemory(wall);
    EXPECT_LE(results.stages.front().health.worst.share, 3e-5);
    EXPECT_LE(results.stages.back().health.steps, 5);
}

/// In a wide wall, bricks of the upper rows slide outwards one after the other. Iterations of the whole wall for each of
/// them would be 150 factorizations, and pseudo-steps that do not converge would leave blocks unbalanced.
TEST(StepWork, WideWallSettlesWithSixtyFactorizationsAtMost) {
    Scene wall = settledWall(80, 62, 0.01);
    wall.analysis.modelEverything = true;
    const Results results = runInMemory(wall);
    const Health& health = results.stages.front().health;
    EXPECT_LE(health.work.factorizations, 60);
    EXPECT_LE(health.worst.share, 3e-5);
}

/// Once a step has changed nothing, later ones are not solved.
TEST(StepWork, WallAtRestTakesTenSolvesAtMost) {
    Scene wall = settledWall(40, 26);
    wall.analysis.modelEverything = true;
    EXPECT_LE(healthAfter(wall, 0.1).steps, 10);
}

TEST(StepWork, SlidingWallTakesFourFactorizationsAtMost) { expectWork(healthAfter(tiltedWall(20, 13), 0.1), 4.0, 2.5); }

TEST(StepWork, SlidingWallOfAThousandBlocksTakesFiveAndAHalfFactorizationsAtMost) {
    expectWork(healthAfter(tiltedWall(40, 26), 0.05), 5.5, 3.5);
}

/// In steps of 0.1 ms the inertia of a brick is about as stiff as its contacts. Sweeps that did not begin from a
/// continuation of the contact forces would be an eighth more.
TEST(StepWork, InShortStepsSweepsAloneSolveMost) {
    Scene wall = tiltedWall(40, 26);
    wall.stages.back().timeStep = 1e-4;
    const Health first = healthAfter(wall, 1e-3), health = healthAfter(wall, 4e-3);
    const long steps = health.steps - first.steps;
    EXPECT_GE(steps, 30);
    EXPECT_LE(health.work.factorizations - first.work.factorizations, 3);
    EXPECT_LE(health.work.sweeps - first.work.sweeps, 24 * steps);
}

/// Displacement of every block over the last stage.
std::vector<Point> motionIn(const Results& results) {
    const Frame& last = results.frames.back();
    const auto first = std::find_if(results.frames.begin(), results.frames.end(),
                                    [&](const Frame& frame) { return frame.stage == last.stage; });
    std::vector<Point> motion;
    for (std::size_t i = 0; i < last.blocks.size(); ++i)
        motion.push_back(last.blocks[i].displacement - first->blocks[i].displacement);
    return motion;
}

/// A step may leave 1e-4 of the forces unbalanced, so that movements may differ from those of nearly exact steps by about
/// as much.
TEST(StepWork, ShortStepsThatSweepsAloneSolveAreAccurate) {
    Scene wall = tiltedWall(40, 26);
    wall.stages.back().timeStep = 1e-4;
    wall.stages.back().duration = 4e-3;
    const std::vector<Point> motion = motionIn(runInMemory(wall));
    wall.analysis.tolerance = 1e-8;
    const std::vector<Point> exact = motionIn(runInMemory(wall));
    double moved = 0.0, apart = 0.0;
    for (std::size_t i = 0; i < motion.size(); ++i) {
        moved = std::max(moved, exact[i].norm());
        apart = std::max(apart, (motion[i] - exact[i]).norm());
    }
    EXPECT_GT(moved, 1e-5);
    EXPECT_LE(apart, 1e-4 * moved);
}

TEST(StepWork, SlidingWallWithBoltsTakesAQuarterMoreAtMost) {
    const Scene plain = tiltedWall(20, 13);
    Scene bolted = plain;
    bolted.boltTypes = builtInBoltTypes();
    for (int i = 0; i < 20; ++i) {
        Bolt bolt;
        bolt.name = "R" + std::to_string(i + 1);
        bolt.type = "rebar-20";
        bolt.divisions = 60;
        const int column = i % 10, row = i / 10;
        bolt.farEnd = {1.27 + 1.8 * column, 1.585 + 2.75 * row};
        bolt.head = bolt.farEnd + Point(1.2, 0.31);
        bolted.bolts.push_back(bolt);
    }
    const Health without = healthAfter(plain, 0.1), with = healthAfter(bolted, 0.1);
    expectWork(with, 1.25 * workOf(without.work) / static_cast<double>(without.steps), 2.7);
}

TEST(StepWork, HoleDugIntoCellsTakesFourAndAHalfFactorizationsAtMost) {
    const SceneReading reading = readSceneText(cells, "cells");
    ASSERT_TRUE(reading.scene);
    expectWork(healthAfter(*reading.scene, 0.09), 4.5, 2.7);
}

TEST(StepWork, UnboltedDriftTakesThreeFactorizationsAtMostAndBalancesItsEnergy) {
    const SceneReading reading = readSceneFile(KEYBLOCK_SAMPLES_DIR "/drift-unbolted.json");
    ASSERT_TRUE(reading.scene);
    long solves = 0;
    StepWork work;
    for (const StageResult& stage : runInMemory(*reading.scene).stages) {
        solves += stage.health.steps;
        work += stage.health.work;
        EXPECT_EQ(stage.health.stepCuts, 0);
        EXPECT_LE(std::abs(stage.health.balanceError), 5e-4);
    }
    ASSERT_GT(solves, 600);
    EXPECT_LE(workOf(work), 3.0 * static_cast<double>(solves));
    EXPECT_LE(static_cast<double>(work.factorizations), 2.5 * static_cast<double>(solves));
}

}  // namespace
}  // namespace keyblock
