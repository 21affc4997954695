// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much work a step in motion takes, counted and never timed: a wall of 1,053
// blocks at rest, a wall of 266 that slides and topples, and a tunnel from which all
// rock is taken at once. No step is cut because it does not settle.
#include "solver/run/run.h"
#include "solver/files/scene_file.h"
#include "wall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double steps = 100.0;

Scene settledWall(int columns, int rows) {
    Scene scene = brickWall({.columns = columns, .rows = rows, .duration = 1e-3 * steps});
    scene.analysis.tolerance = 1e-4;
    scene.analysis.penaltyRatio = 40.0;
    scene.materials[0].second.poissonsRatio = 0.2;
    Stage settle;
    settle.name = "settle";
    scene.stages.insert(scene.stages.begin(), settle);
    return scene;
}

Scene tiltedWall(int columns, int rows) {
    Scene scene = settledWall(columns, rows);
    Stage& tilted = scene.stages.back();
    tilted.set = {{"joint", 20.0}};
    Acceleration along;
    along.record = {{0.0, 1.0}, {1.0, 1.0}};
    along.factor = 9.81 * std::sin(25.0 * std::numbers::pi / 180.0);
    tilted.bodyAcceleration = along;
    return scene;
}

/// Work and factorizations of a solve of the last stage, the search for its first forces included.
void expectWork(const Scene& scene, double mostWork, double mostFactorizations) {
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2u);
    const StageResult& stage = results.stages.back();
    EXPECT_EQ(stage.outcome, Outcome::Duration) << stage.message;
    EXPECT_EQ(stage.health.stepCuts, 0);
    EXPECT_EQ(stage.health.energyCuts, 0);
    const double solves = static_cast<double>(stage.health.steps);
    EXPECT_GE(solves, steps);
    EXPECT_LE(workOf(stage.health.work) / solves, mostWork);
    EXPECT_LE(static_cast<double>(stage.health.work.factorizations) / solves, mostFactorizations);
}

TEST(StepWork, OfAWallAtRestIsLessThanOneFactorization) { expectWork(settledWall(40, 26), 1.0, 1.2); }

TEST(StepWork, OfAWallThatSlidesIsThatOfAFewFactorizations) { expectWork(tiltedWall(20, 13), 5.5, 3.5); }

}  // namespace
}  // namespace keyblock
