// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static stages whose increments are null: one increment where everything follows
// straight lines, shorter ones where joints slide, and frames at the pseudo-times
// that the scene asks for.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>
#include <vector>

namespace keyblock {
namespace {

constexpr double boxWeight = 2500.0 * gravity;  // of the box [N]

/// A box on a base settles; then a force along the base rises to `force` [N].
Scene pushedBox(double force, double frictionAngle) {
    Scene scene = test::boxOnBase(0.0, frictionAngle);
    scene.output = {};
    for (auto& [name, material] : scene.materials) material.density = 2500.0;
    Stage push = test::settle();
    push.name = "push";
    Load load;
    load.blockAt = Point(0.5, 0.5);
    load.at = Point(0.5, 0.1);
    load.force = {force, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    push.loads = {load};
    scene.stages = {test::settle(), push};
    return scene;
}

/// The same box is moved along the base, so that it slides.
Scene draggedBox(double displacement) {
    Scene scene = pushedBox(0.0, 30.0);
    scene.stages[1].loads.clear();
    scene.stages[1].motions = {{{0.5, 0.5}, {1.0, 0.0}, {{0.0, 0.0}, {1.0, displacement}}, Rotation::Held}};
    return scene;
}

double workOfPush(const Scene& scene) { return workOf(runInMemory(scene).stages.at(1).health.work); }

std::vector<double> frameTimes(const Results& results, int stage) {
    std::vector<double> times;
    for (const Frame& frame : results.frames)
        if (frame.stage == stage) times.push_back(frame.time);
    return times;
}

/// Friction force of the box on its base [N].
double frictionOf(const Frame& frame) {
    double force = 0.0;
    for (const ContactFrame& contact : frame.contacts) force += contact.shearForce;
    return std::abs(force);
}

TEST(Increments, BoxThatSticksTakesOne) {
    Scene scene = pushedBox(0.2 * boxWeight, 45.0);
    const Results chosen = runInMemory(scene);
    EXPECT_EQ(chosen.stages[1].steps, 2) << "one at once, one for the load that rises";
    scene.stages[1].increments = 50;
    const Results many = runInMemory(scene);
    const double moved = many.frames.back().blocks[1].displacement.x();
    EXPECT_NEAR(chosen.frames.back().blocks[1].displacement.x(), moved, 1e-4 * std::abs(moved));
}

/// Once it slides, forces and displacements follow straight lines again, and increments grow.
TEST(Increments, SlidingBoxHasItsFriction) {
    const Results results = runInMemory(draggedBox(0.01));
    const std::vector<double> times = frameTimes(results, 1);
    EXPECT_GE(times.size(), 4u);
    EXPECT_LE(times.at(1), 1.0 / 7.0) << "while it begins to slide";
    EXPECT_NEAR(frictionOf(results.frames.back()), boxWeight * std::tan(30.0 * degree), 1e-3 * boxWeight);
    EXPECT_NEAR(results.frames.back().blocks[1].displacement.x(), 0.01, 1e-12);
}

/// One increment is never dearer than ten; if it is given up for shorter ones, that may cost eight iterations more.
TEST(Increments, CostNoMoreThanTenEqualOnes) {
    const double trial = 8 * 1.2;  // factorizations, with what belongs to an iteration
    for (Scene scene : {pushedBox(0.2 * boxWeight, 45.0), pushedBox(0.5 * boxWeight, 30.0), draggedBox(0.01)}) {
        const double chosen = workOfPush(scene);
        scene.stages[1].increments = 1;
        const double one = workOfPush(scene);
        scene.stages[1].increments = 10;
        const double ten = workOfPush(scene);
        EXPECT_LE(chosen, 1.2 * ten + trial);
        EXPECT_LE(one, 1.2 * ten);
    }
}

TEST(Increments, FramesAtTimesAskedFor) {
    for (Scene scene : {pushedBox(0.2 * boxWeight, 45.0), draggedBox(0.01)}) {
        scene.output.every = 0.3;
        EXPECT_EQ(frameTimes(runInMemory(scene), 1), (std::vector<double>{0.0, 0.3, 2 * 0.3, 3 * 0.3, 1.0}));
    }
}

TEST(Increments, FramesAsManyAsAskedFor) {
    Scene scene = pushedBox(0.2 * boxWeight, 45.0);
    scene.output.frames = 8;  // four in each of the two stages
    EXPECT_EQ(frameTimes(runInMemory(scene), 1), (std::vector<double>{0.0, 0.25, 0.5, 0.75, 1.0}));
}

/// Load follows a table that turns: the box is pushed one way until it slides, and back.
TEST(Increments, EndWhereTheLoadTurns) {
    Scene scene = draggedBox(0.01);
    scene.stages[1].motions[0].table = {{0.0, 0.0}, {0.37, 0.004}, {1.0, 0.0}};
    const std::vector<double> times = frameTimes(runInMemory(scene), 1);
    EXPECT_NE(std::find(times.begin(), times.end(), 0.37), times.end());
}

/// A box that tips over its corner turns so far that its corners' arcs count.
TEST(Increments, FollowRotation) {
    Scene scene = pushedBox(0.0, 60.0);
    scene.stages[1].loads.clear();
    scene.stages[1].motions = {{{0.5, 0.5}, {1.0, 0.0}, {{0.0, 0.0}, {1.0, 0.3}}, Rotation::Free}};
    const Results results = runInMemory(scene);
    double before = 0.0;
    for (const Frame& frame : results.frames) {
        EXPECT_LE(std::abs(frame.blocks[1].rotation - before), 0.021);
        before = frame.blocks[1].rotation;
    }
    EXPECT_GT(std::abs(before), 0.2);
}

/// A column is pushed at its top until it tips against a wall, by more than the 0.02 rad that it may turn in an
/// increment. It tips at one load, so that shorter increments turn it as far; a search in which it tips takes ten to
/// twenty pseudo-steps, and only few may be made.
TEST(Increments, DoNotLocateABlockThatTipsAtOneLoad) {
    constexpr double height = 4.0, gap = 0.15, weight = height * boxWeight;
    constexpr double tipping = 0.5 * weight / height;  // force at the top [N]
    Scene scene = pushedBox(1.9 * tipping, 45.0);
    scene.blocks[1] = boxBlock("column", {0, 0}, {1, height});
    scene.blocks.push_back(boxBlock("wall", {1 + gap, 0}, {2 + gap, height}));
    scene.supports.push_back(scene.supports[0]);
    scene.supports.back().blockAt = Point(1.5, 0.5);
    scene.stages[1].loads[0].at = Point(0.0, height);
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[1].outcome, Outcome::Equilibrium) << results.stages[1].message;
    EXPECT_NEAR(std::abs(results.frames.back().blocks[1].rotation), gap / height, 0.02 * gap / height);
    EXPECT_LE(results.stages[1].health.steps - results.stages[0].health.steps, 90);
}

using Failure = std::tuple<EventKind, int, int, int>;

/// Failures of the rebar that is pulled across a joint, in order: kind, bolt, node and element.
std::vector<Failure> failuresOfRebar(std::optional<int> increments) {
    SceneReading reading = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / "rebar-20.json");
    if (!reading.scene) return {};
    reading.scene->stages[0].increments = increments;
    std::vector<Failure> failures;
    for (const Event& e : runInMemory(*reading.scene).events)
        if (e.kind != EventKind::Restick) failures.emplace_back(e.kind, e.bolt, e.node, e.element);
    return failures;
}

/// The parts on both sides of the joint have the same strength, so that a small error of an equilibrium could decide
/// which of them fails first.
TEST(Increments, ThatTheProgramChoosesGiveTheSameOrderOfFailures) {
    const std::vector<Failure> failures = failuresOfRebar(std::nullopt);
    EXPECT_GE(failures.size(), 10U);
    EXPECT_EQ(failures, failuresOfRebar(200));
}

}  // namespace
}  // namespace keyblock
