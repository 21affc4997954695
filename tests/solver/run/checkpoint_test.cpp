// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run taken up at any of its checkpoints, after a way through bytes, ends with the
// same results to the last bit; and a run that is paused goes on one step at a time.
#include "solver/run/checkpoint.h"

#include "solver/run/run.h"
#include "tests/solver/run/checkpoint_scenes.h"
#include "tests/wait_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

namespace keyblock {
namespace {

using test::dynamic;
using test::KeepingSink;
using test::runKept;
using test::sliding;
using test::staged;
using test::tearing;

void expectTheSameFromEveryCheckpoint(const Scene& scene, std::size_t atLeast) {
    const KeepingSink whole = runKept(scene);
    EXPECT_GE(whole.kept.size(), atLeast);
    for (std::size_t i = 0; i < whole.kept.size(); ++i) {
        const std::optional<Checkpoint> from = checkpointOf(whole.kept[i]);
        ASSERT_TRUE(from);
        KeepingSink sink;
        sink.results = whole.results;  // the sink has everything, also what came later
        Control control;
        const std::vector<StageResult> stages = run(scene, sink, control, {}, &*from);
        EXPECT_EQ(stages, whole.results.stages) << "checkpoint " << i;
        EXPECT_TRUE(sink.results == whole.results) << "checkpoint " << i;
        EXPECT_TRUE(std::equal(sink.kept.begin(), sink.kept.end(),
                               whole.kept.end() - static_cast<std::ptrdiff_t>(sink.kept.size())))
            << "checkpoint " << i;
    }
}

TEST(Checkpoints, AStaticRunGoesOnBetweenItsReleases) { expectTheSameFromEveryCheckpoint(tearing(), 4); }

TEST(Checkpoints, ChosenIncrementsGoOn) {
    Scene scene = tearing(39);
    scene.stages[0].increments.reset();
    expectTheSameFromEveryCheckpoint(scene, 2);
}

TEST(Checkpoints, ADynamicRunGoesOn) { expectTheSameFromEveryCheckpoint(sliding(1.5), 4); }

/// Three boxes at rest that may not fall asleep.
TEST(Checkpoints, ADynamicRunInWhichNothingChangesGoesOn) {
    Scene scene = sliding(10.0);
    scene.analysis.gravity = {0.0, -9.81};
    scene.analysis.tolerance = 1e-4;
    scene.analysis.modelEverything = true;
    scene.stages.insert(scene.stages.begin(), test::settle());
    EXPECT_TRUE(checkpointOf(runKept(scene).kept.back())->pace.still);
    expectTheSameFromEveryCheckpoint(scene, 3);
}

TEST(Checkpoints, ARunOfManyStagesGoesOn) { expectTheSameFromEveryCheckpoint(staged(), 6); }

/// Rock that goes, bolts that come and go, joints that dilate, sides that let waves out are there again as they were.
TEST(Checkpoints, ARunWhoseRockAndBoltsComeAndGoGoesOn) {
    Scene scene = tearing();
    const std::string bolt = scene.bolts[0].name;
    Stage first, second, third = dynamic(0.3, 1e-3), fourth;
    first.name = "install";
    first.install = {bolt};
    first.dilations = {{scene.jointMaterials[0].first, 1e-3}};
    second.name = "excavate";
    second.excavate = {"right"};
    second.relaxation = 0.3;
    third.viscousBoundaries = {"right"};
    fourth.name = "remove";
    fourth.remove = {bolt};
    scene.stages = {first, second, third, fourth};
    expectTheSameFromEveryCheckpoint(scene, 4);
}

/// A box slides for a long time beside a pile that sleeps, and then into it.
TEST(Checkpoints, ARunInWhichBlocksSleepGoesOn) {
    Scene scene = sliding(1.2);
    scene.blocks = {boxBlock("base", {-1, -1}, {14, 0}), boxBlock("slides", {0, 0}, {1, 1})};
    for (int i = 0; i < 4; ++i)
        scene.blocks.push_back(boxBlock("p" + std::to_string(i), {5, 0.5 * i}, {6, 0.5 * i + 0.5}));
    scene.analysis.gravity = {0.0, -9.81};
    scene.stages[0].initialVelocities = {{{0.5, 0.5}, {7.0, 0.0}}};
    expectTheSameFromEveryCheckpoint(scene, 3);
    const Health health = runKept(scene).results.stages[0].health;
    EXPECT_LT(health.awake, 3 * health.movable / 4);
}

/// What the stages set of the joints and what the schemes carry from step to step is there again.
TEST(Checkpoints, ARunWhoseJointsAndSchemesChangeGoesOn) {
    Scene scene = sliding(0.3);
    for (const Integration integration : {Integration::GeneralizedAlpha, Integration::Newmark}) {
        Stage next = scene.stages[0];
        next.integration = integration;
        StrengthChange weaker;
        weaker.jointMaterial = scene.jointMaterials[0].first;
        weaker.frictionAngle = integration == Integration::Newmark ? 3.0 : 12.0;
        next.set = {weaker};
        scene.stages.push_back(next);
    }
    expectTheSameFromEveryCheckpoint(scene, 5);
}

TEST(Checkpoints, OneIncrementOfManyReleasesHasSome) {
    Scene scene = tearing(79);
    scene.stages[0].increments = 1;
    const KeepingSink whole = runKept(scene);
    std::size_t inside = 0;
    for (const std::string& bytes : whole.kept) {
        const Checkpoint checkpoint = checkpointOf(bytes).value();
        inside += checkpoint.within.done > 0.0 || checkpoint.within.releasing ? 1u : 0u;
    }
    EXPECT_GE(inside, 1u) << whole.kept.size();
    expectTheSameFromEveryCheckpoint(scene, 2);
}

/// The displacement from which that over the next increment is estimated: the pulled block moves by 4 mm in all.
TEST(Checkpoints, TheDisplacementOverTheLastIncrementIsKept) {
    int seen = 0;
    for (const std::string& bytes : runKept(tearing()).kept) {
        const LoadResponse response = checkpointOf(bytes).value().within.response;
        if (response.moved.empty()) continue;
        ++seen;
        const auto moved = [&](std::size_t block) {
            return std::hypot(response.moved[6 * block], response.moved[6 * block + 1]);
        };
        EXPECT_NEAR(std::max(moved(0), moved(1)), response.length * 4e-3, 1e-9 * 4e-3);
    }
    EXPECT_GE(seen, 3);
}

/// Stops the run from its own thread after so many frames.
class StoppingSink : public KeepingSink {
public:
    void frame(const Frame& frame) override {
        MemorySink::frame(frame);
        if (static_cast<int>(results.frames.size()) >= stopAfter && control) control->stop = true;
    }

    Control* control = nullptr;
    int stopAfter = 0;
};

TEST(Checkpoints, AStoppedRunGoesOnAndEndsTheSame) {
    for (const Scene& scene : {tearing(), sliding(0.4), staged()}) {
        const KeepingSink whole = runKept(scene);
        for (int frames = 1; frames < static_cast<int>(whole.results.frames.size()); frames += 3) {
            StoppingSink sink;
            Control control;
            sink.control = &control;
            sink.stopAfter = frames;
            const std::vector<StageResult> stopped = run(scene, sink, control);
            if (stopped.back().outcome != Outcome::Stopped) continue;  // asked during the last step
            sink.control = nullptr;
            control.stop = false;
            const Checkpoint from = checkpointOf(sink.kept.back()).value();
            run(scene, sink, control, {}, &from);
            EXPECT_TRUE(sink.results == whole.results) << "stopped after " << frames << " frames";
        }
    }
}

TEST(Checkpoints, APausedRunTakesOneStepForEachThatIsAsked) {
    Scene scene = sliding(100.0);
    MemorySink sink;
    Control control;
    std::atomic<long> steps{0};
    std::atomic<int> looks{0};
    control.progress = [&](const Progress& progress) { steps = progress.steps; };
    control.looked = [&](const Frame&) { ++looks; };
    control.pause = true;
    std::thread worker([&] { run(scene, sink, control); });
    // A state is handed over between two steps only. The first one after the last request follows the requested step;
    // a run that did not pause would take another step before the second one.
    const auto stepsAtRest = [&] {
        EXPECT_TRUE(test::waitFor([&] { return control.steps == 0; }));
        for (int look = 0; look < 2; ++look) {
            const int before = looks;
            control.look = true;
            EXPECT_TRUE(test::waitFor([&] { return looks > before; }));
        }
        return steps.load();
    };
    control.steps = 1;  // the stage begins
    EXPECT_EQ(stepsAtRest(), 0);
    control.steps = 5;  // progress tells of the step that is being solved
    EXPECT_EQ(stepsAtRest(), 4);
    control.steps = 2;
    EXPECT_EQ(stepsAtRest(), 6);
    control.pause = false;
    EXPECT_TRUE(test::waitFor([&] { return steps >= 20; }));
    control.pause = true;
    control.stop = true;  // also while paused
    worker.join();
    EXPECT_EQ(sink.results.stages.back().outcome, Outcome::Stopped);
}

TEST(Checkpoints, LookingAtStatesBetweenStepsChangesNothing) {
    const Scene scene = sliding(100.0);
    const Results unwatched = runInMemory(scene);
    MemorySink sink;
    Control control;
    std::vector<Frame> seen;
    control.look = true;
    control.looked = [&](const Frame& frame) {
        seen.push_back(frame);
        control.look = true;
    };
    run(scene, sink, control);
    EXPECT_TRUE(sink.results == unwatched);
    ASSERT_GT(seen.size(), sink.results.frames.size());
    for (Frame kept : sink.results.frames) {
        if (kept == sink.results.frames.back()) continue;  // nobody looks once the stage is over
        EXPECT_FALSE(kept.forces.bodies.empty());
        kept.forces = {};  // are found for frames that are kept
        EXPECT_NE(std::find(seen.begin(), seen.end(), kept), seen.end()) << "frame at " << kept.time;
    }
}

TEST(Checkpoints, ProgressTellsOfTheNewestStep) {
    MemorySink sink;
    Control control;
    int mostPasses = 0;
    double deepest = 0.0;
    control.progress = [&](const Progress& progress) {
        mostPasses = std::max(mostPasses, progress.step.passes);
        deepest = std::max(deepest, progress.step.penetrationRatio);
        EXPECT_EQ(progress.step.penetrationRatio > 0.0, progress.step.penetrated >= 0);
    };
    run(sliding(100.0), sink, control);
    EXPECT_GT(mostPasses, 0);
    EXPECT_LE(deepest, sink.results.stages.back().health.maxPenetrationRatio);
    EXPECT_GT(deepest, 0.0);
}

}  // namespace
}  // namespace keyblock
