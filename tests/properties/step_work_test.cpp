// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much work a step in motion takes, counted and never timed: a wall of 1,053
// blocks at rest, one of 266 that slides and topples, and the drift without bolts.
// No step is cut.
#include "solver/files/scene_file.h"
#include "solver/run/run.h"
#include "wall.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

Health healthAfter(Scene scene, double duration) {
    scene.stages.back().duration = duration;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.back().outcome, Outcome::Duration) << results.stages.back().message;
    return results.stages.back().health;
}

/// Mean work and factorizations of a solve in steps 11 to 100 of the last stage.
void expectWork(const Scene& scene, double mostWork, double mostFactorizations) {
    const Health first = healthAfter(scene, 0.01), all = healthAfter(scene, 0.1);
    EXPECT_EQ(all.stepCuts, 0);
    EXPECT_EQ(all.energyCuts, 0);
    const double solves = static_cast<double>(all.steps - first.steps);
    EXPECT_GE(solves, 90.0);
    EXPECT_LE((workOf(all.work) - workOf(first.work)) / solves, mostWork);
    EXPECT_LE(static_cast<double>(all.work.factorizations - first.work.factorizations) / solves, mostFactorizations);
}

TEST(StepWork, WallAtRestTakesLessThanOneFactorization) { expectWork(settledWall(40, 26), 1.0, 1.2); }

TEST(StepWork, SlidingWallTakesFiveFactorizationsAtMost) { expectWork(tiltedWall(20, 13), 5.0, 3.5); }

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
