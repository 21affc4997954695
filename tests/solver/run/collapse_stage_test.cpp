// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motion that follows a collapse where the stage asks for it.
#include "solver/scene/collapse_stage.h"

#include "solver/results/run_source.h"
#include "solver/results/verdict.h"
#include "solver/results/result_names.h"
#include "solver/run/run.h"
#include "solver/scene/check.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using test::settle;

constexpr double duration = 0.5;  // [s]

Stage followed(const std::string& name) {
    Stage stage;
    stage.name = name;
    stage.onCollapse = OnCollapse::Dynamic;
    stage.collapseDuration = duration;
    return stage;
}

/// A block on a slope of 30° that loses its friction, and a stage after that.
Scene slidingScene(double friction, bool goesOn) {
    Scene scene = inclineScene(30.0, 35.0, 1.0);
    Stage weaken = followed("weaken"), after = followed("after");
    weaken.set = {{"joint", friction, 0.0, 0.0}};
    weaken.continueAfterCollapse = goesOn;
    after.onCollapse = OnCollapse::End;
    scene.stages = {settle(), weaken, after};
    return scene;
}

std::vector<std::string> stagesRun(const Scene& scene, const Results& results) {
    std::vector<std::string> names;
    for (const StageResult& result : results.stages) names.push_back(stageName(withCollapseStages(scene), result.stage));
    return names;
}

/// How far the last block goes in a stage [m].
double wayIn(const Results& results, int stage) {
    const auto inStage = [&](const Frame& frame) { return frame.stage == stage; };
    const auto first = std::find_if(results.frames.begin(), results.frames.end(), inStage);
    const auto last = std::find_if(results.frames.rbegin(), results.frames.rend(), inStage);
    if (first == results.frames.end()) return 0.0;
    return (last->blocks.back().centroid - first->blocks.back().centroid).norm();
}

TEST(CollapseStage, FollowsTheSlidingBlock) {
    const Scene scene = slidingScene(20.0, true);
    const Results results = runInMemory(scene);
    EXPECT_EQ(stagesRun(scene, results), (std::vector<std::string>{"settle", "weaken", "weaken (collapse)", "after"}));
    EXPECT_EQ(results.stages[1].outcome, Outcome::Collapse);
    EXPECT_EQ(results.stages[2].outcome, Outcome::Duration);
    EXPECT_DOUBLE_EQ(results.stages[2].time, duration);
    const double a = gravity * (std::sin(30.0 * degree) - std::cos(30.0 * degree) * std::tan(20.0 * degree));
    EXPECT_NEAR(wayIn(results, 2), 0.5 * a * duration * duration, 5e-3 * a * duration * duration);
}

/// A search ends when the block has moved by its size. In steps of at most 0.03 times its size this takes over 33 steps;
/// once it is seen to fall, after eleven, the steps may be 0.1 times its size, and nine are enough.
TEST(CollapseStage, TheSearchFollowsAFallInLongSteps) {
    const Results results = runInMemory(slidingScene(20.0, false));
    ASSERT_EQ(results.stages[1].outcome, Outcome::Collapse);
    EXPECT_LE(results.stages[1].health.steps, 25) << results.stages[1].health.steps;
}

TEST(CollapseStage, IsSkippedWhereNothingFalls) {
    const Scene scene = slidingScene(32.0, false);
    const Results results = runInMemory(scene);
    EXPECT_EQ(stagesRun(scene, results), (std::vector<std::string>{"settle", "weaken", "after"}));
    const MemoryRun run(scene, results);
    EXPECT_TRUE(isFinished(run));
    EXPECT_EQ(verdictOf(run.stages(), run.scene()).stands, true);
}

TEST(CollapseStage, EndsTheRunThatIsNotToGoOn) {
    const Scene scene = slidingScene(20.0, false);
    const Results results = runInMemory(scene);
    EXPECT_EQ(stagesRun(scene, results), (std::vector<std::string>{"settle", "weaken", "weaken (collapse)"}));
    EXPECT_TRUE(isFinished(MemoryRun(scene, results)));
}

/// From the side against friction of 20°: what the collapse was found under goes on pushing.
TEST(CollapseStage, KeepsTheAccelerationOfTheStage) {
    Scene scene = inclineScene(0.0, 20.0, 1.0);
    Stage shaken = followed("shaken");
    shaken.bodyAcceleration = Acceleration{};
    shaken.bodyAcceleration->value = 0.5;
    shaken.bodyAcceleration->factor = gravity;
    scene.stages = {settle(), shaken};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 3u);
    ASSERT_EQ(results.stages[1].outcome, Outcome::Collapse);
    const double share = std::tan(20.0 * degree) / 0.5, finest = 0.02;  // it slides from there on, by less than the finest
    EXPECT_GT(results.stages[1].time, share - finest);
    EXPECT_LT(results.stages[1].time, share);
    const double rest = 1e-4 * gravity;  // so little may be left of all forces at rest
    EXPECT_GT(wayIn(results, 2), 0.5 * rest * duration * duration);
    EXPECT_LT(wayIn(results, 2), 0.5 * 0.5 * finest * gravity * duration * duration);
}

TEST(CollapseStage, HasAName) {
    Scene scene = slidingScene(20.0, true);
    scene.stages[2].name = "weaken (collapse)";
    const std::vector<Problem> problems = checkScene(scene);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].pointer, "/stages/2/name");
}

TEST(CollapseStage, IsAddedOnce) {
    const Scene once = withCollapseStages(slidingScene(20.0, true));
    EXPECT_EQ(once.stages.size(), 4u);
    EXPECT_EQ(withCollapseStages(once), once);
}

}  // namespace
}  // namespace keyblock
