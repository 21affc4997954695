// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks at rest are left out of dynamic steps and wake in time: runs in which blocks
// may sleep give the events and positions of runs in which everything is modelled.
#include "solver/results/block_forces.h"
#include "solver/run/run.h"
#include "solver/scene/preset.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using test::boxOnBase;
using test::dynamic;

/// Share of the blocks that moved with the steps of the last stage, averaged over its steps.
double awakeShare(const Results& results) {
    const Health& health = results.stages.back().health;
    return static_cast<double>(health.awake) / static_cast<double>(health.movable);
}

struct Both {
    Results everything, sleeping;
};

Both runBoth(Scene scene) {
    Both both;
    scene.analysis.modelEverything = true;
    both.everything = runInMemory(scene);
    scene.analysis.modelEverything = false;
    both.sleeping = runInMemory(scene);
    return both;
}

/// Largest distance between the centroids of a block in both runs [m].
double apart(const Both& both) {
    const Frame &a = both.everything.frames.back(), &b = both.sleeping.frames.back();
    double largest = 0.0;
    for (std::size_t i = 0; i < a.blocks.size(); ++i)
        largest = std::max(largest, (a.blocks[i].centroid - b.blocks[i].centroid).norm());
    return largest;
}

/// The events of a run without their numbers: what happened where, in order.
std::vector<std::array<int, 5>> eventsOf(const Results& results) {
    std::vector<std::array<int, 5>> events;
    for (const Event& e : results.events)
        events.push_back({static_cast<int>(e.kind), e.bolt, e.node, e.block, e.otherBlock});
    return events;
}

/// A running bond of bricks of 1 m × 0.5 m on a fixed slab, settled, then a dynamic stage.
Scene wall(int columns, int rows, double duration) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("slab", {-1, -1}, {columns + 1.5, 0})};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Point low(column + 0.5 * (row % 2), 0.5 * row);
            scene.blocks.push_back(
                boxBlock("r" + std::to_string(row) + "c" + std::to_string(column), low, low + Point(1.0, 0.5)));
        }
    Support support;
    support.blockAt = Point(0.5, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.output.frames = 8;
    scene.stages = {test::settle(), dynamic(duration, 1e-3)};
    return scene;
}

Load forceAt(const Point& place, const Point& force, const Table& table) {
    Load load;
    load.point = place;
    load.force = force;
    load.table = table;
    return load;
}

InitialVelocity moving(const Point& block, const Point& velocity) {
    InitialVelocity initial;
    initial.blockAt = block;
    initial.velocity = velocity;
    return initial;
}

TEST(Sleep, AWallAtRestIsLeftOutOfTheSteps) {
    const Both both = runBoth(wall(6, 6, 0.2));
    EXPECT_EQ(awakeShare(both.everything), 1.0);
    EXPECT_LE(awakeShare(both.sleeping), 0.16);  // of 200 steps, the first 20 and up to 10 more
    EXPECT_LT(apart(both), 1e-9);
    EXPECT_NEAR(both.sleeping.stages.back().health.balanceError, both.everything.stages.back().health.balanceError,
                1e-6);
}

/// The wall has settled: once a step has changed nothing, later ones under the same loads need no solution.
TEST(Sleep, AStepThatChangesNothingIsNotSolvedAgain) {
    Scene scene = wall(6, 6, 0.2);
    scene.analysis.tolerance = 1e-4;
    scene.analysis.modelEverything = true;
    const Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.back().steps, 200);
    EXPECT_LE(results.stages.back().health.steps, 10);
    for (const BlockState& block : results.frames.back().blocks) EXPECT_EQ(block.velocity.norm(), 0.0);
}

/// The load rises from nothing after a second in which nothing changes. 12 kN push a brick of 1.35 t, whose friction
/// carries 7.65 kN, so that it accelerates by 3.23 m/s2.
TEST(Sleep, ALoadMovesABrickThatStoodStillWhileEverythingIsModelled) {
    Scene scene = wall(1, 1, 1.2);
    scene.analysis.tolerance = 1e-4;
    scene.analysis.modelEverything = true;
    scene.stages.back().loads = {
        forceAt({0.5, 0.25}, {12000.0, 0.0}, {{0.0, 0.0}, {1.0, 0.0}, {1.0001, 1.0}, {1.2, 1.0}})};
    const Results results = runInMemory(scene);
    const double acceleration = 12000.0 / 1350.0 - gravity * std::tan(std::numbers::pi / 6.0);
    const double slid = results.frames.back().blocks.back().displacement.x();
    EXPECT_NEAR(slid, 0.5 * acceleration * 0.2 * 0.2, 0.01 * slid);  // the first step is half a step late or early
    EXPECT_LE(results.stages.back().health.steps, 220);
}

/// The push exceeds friction by 2.5e-4 of the weight, far less than what the tolerance allows of the forces on the wall
/// next to the brick.
TEST(Sleep, ABrickThatStartsSlowlyIsNotKeptAtRest) {
    for (const bool everything : {true, false}) {
        Scene scene = wall(10, 10, 1.0);
        scene.blocks.front() = boxBlock("slab", {-1, -1}, {20, 0});
        scene.blocks.push_back(boxBlock("pushed", {15, 0}, {16, 0.5}));
        scene.analysis.tolerance = 1e-4;
        scene.analysis.modelEverything = everything;
        const double excess = 2.5e-4 * gravity, weight = 1350.0 * gravity;  // [m/s2], [N]
        const Point push(std::tan(std::numbers::pi / 6.0) * weight + 1350.0 * excess, 0.0);
        scene.stages.back().loads = {forceAt({15.5, 0.01}, push, {})};
        const Results results = runInMemory(scene);
        const double slid = results.frames.back().blocks.back().displacement.x();
        EXPECT_NEAR(slid, 0.5 * excess, 0.02 * 0.5 * excess) << everything;
    }
}

TEST(Sleep, AZeroToleranceKeepsEverythingAwake) {
    Scene scene = wall(3, 3, 0.1);
    scene.analysis.sleepTolerance = 0.0;
    const Results none = runInMemory(scene);
    EXPECT_EQ(awakeShare(none), 1.0);
    scene.analysis.modelEverything = true;
    EXPECT_EQ(runInMemory(scene).frames, none.frames);
}

TEST(Sleep, WithoutWeightNothingSleeps) {
    Scene scene = wall(3, 3, 0.1);
    scene.analysis.gravity = {0.0, 0.0};
    scene.stages.erase(scene.stages.begin());
    EXPECT_EQ(awakeShare(runInMemory(scene)), 1.0);
}

/// 1 kN on a brick, of which the friction under it carries all.
TEST(Sleep, ALoadWakesTheWall) {
    Scene scene = wall(6, 6, 0.2);
    scene.stages.back().loads = {
        forceAt({5.7, 2.9}, {1000.0, 0.0}, {{0.0, 0.0}, {0.1, 0.0}, {0.1001, 1.0}, {0.2, 1.0}})};
    const Both both = runBoth(scene);
    EXPECT_LT(awakeShare(both.sleeping), 0.7);
    EXPECT_LT(apart(both), 1e-6 * 0.5);  // of a brick's height
    EXPECT_EQ(eventsOf(both.everything), eventsOf(both.sleeping));
}

/// 12 kN are more than friction carries: the brick slides off.
TEST(Sleep, ALoadPushesASleepingBrickAway) {
    Scene scene = wall(4, 4, 0.4);
    scene.stages.back().loads = {
        forceAt({3.9, 1.9}, {12000.0, 0.0}, {{0.0, 0.0}, {0.1, 0.0}, {0.1001, 1.0}, {0.4, 1.0}})};
    const Both both = runBoth(scene);
    const Point slid = both.everything.frames.back().blocks.back().displacement;
    EXPECT_GT(slid.x(), 0.05);
    EXPECT_LT(apart(both), 1e-3 * slid.x());
}

/// The second dynamic stage begins while every block sleeps.
TEST(Sleep, ALoadOfTheNextStageMovesABrickThatSlept) {
    Scene scene = wall(3, 2, 0.1);
    scene.stages.push_back(dynamic(0.1, 1e-3));
    scene.stages.back().name = "push";
    scene.stages.back().loads = {forceAt({3.4, 0.9}, {12000.0, 0.0}, {{0.0, 1.0}, {0.1, 1.0}})};
    const Both both = runBoth(scene);
    EXPECT_LT(awakeShare(both.sleeping), 1.0);
    const Point slid = both.everything.frames.back().blocks.back().displacement;
    EXPECT_GT(slid.x(), 0.01);
    EXPECT_LT(apart(both), 1e-3 * slid.x());
}

/// Under stress from all sides, so that contacts carry many times the weights.
TEST(Sleep, UnderEverySchemeWhatWakesHasTheForcesThatItHad) {
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler, Integration::Newmark,
                                     Integration::GeneralizedAlpha}) {
        Scene scene = wall(5, 5, 0.3);
        scene.stages.front().loads = {forceAt({2.5, 2.4}, {0.0, -300e3}, {})};
        scene.stages.back().integration = scheme;
        scene.stages.back().loads = {forceAt({2.5, 2.4}, {0.0, -300e3}, {}),
                                     forceAt({4.9, 2.4}, {20e3, 0.0}, {{0.0, 0.0}, {0.1, 0.0}, {0.1001, 1.0}, {0.3, 1.0}})};
        const Both both = runBoth(scene);
        const Frame& frame = both.everything.frames.back();
        double moved = 0.0;
        for (const BlockState& block : frame.blocks) moved = std::max(moved, block.displacement.norm());
        EXPECT_GT(moved, 0.02);
        EXPECT_LT(apart(both), 2e-3 * moved) << static_cast<int>(scheme);
        EXPECT_LT(awakeShare(both.sleeping), 0.95) << static_cast<int>(scheme);
    }
}

/// It lands after 0.25 s. From then on the smallest difference grows thirtyfold or more in 0.02 s, also between two runs
/// in which everything is modelled, and by how much depends on the kernel of OpenBLAS; therefore the runs end 0.05 s
/// later.
TEST(Sleep, ABlockThatLandsWakesThePile) {
    Scene scene = wall(4, 4, 0.3);
    scene.blocks.push_back(boxBlock("falls", {1.6, 2.3}, {2.4, 2.9}));
    scene.stages.erase(scene.stages.begin());
    const Both both = runBoth(scene);
    EXPECT_LT(awakeShare(both.sleeping), 0.9);
    EXPECT_LT(apart(both), 1e-6 * 0.5);  // of a brick's height
    EXPECT_EQ(eventsOf(both.everything), eventsOf(both.sleeping));
}

/// The forces on a sleeping block sum to no more than the tolerance, those on one that is awake to its inertia force.
TEST(Sleep, TheForcesOfAFrameBalanceEveryBlock) {
    Scene scene = wall(4, 4, 0.2);
    scene.blocks.push_back(boxBlock("slides", {6.0, 0.0}, {7.0, 0.5}));
    scene.blocks.front() = boxBlock("slab", {-1, -1}, {30, 0});
    scene.stages.back().initialVelocities = {moving({6.5, 0.25}, {2.0, 0.0})};
    const Results results = runInMemory(scene);
    EXPECT_LT(awakeShare(results), 0.3);
    const Frame& frame = results.frames.back();
    EXPECT_GT(frame.blocks.back().velocity.x(), 0.5);
    std::vector<Point> sums(frame.blocks.size(), Point(0.0, 0.0));
    for (const BlockForce& force : blockForces(frame)) sums[force.block] += force.force;
    for (std::size_t i = 1; i < sums.size(); ++i)
        EXPECT_LT(sums[i].norm(), 2.0 * numericsOf(scene.analysis).sleepTolerance * frame.blocks[i].weight) << i;
    for (const BlockForce& force : blockForces(frame))  // what sleeps is not held
        EXPECT_TRUE(force.source != ForceSource::Support || force.block == 0) << force.block;
}

/// A box slides along a plank that rests on a base, without accelerating it, and past the end of the base: the moment
/// of its constant weight tips the plank.
TEST(Sleep, AForceThatMovesAlongASleepingBlockWakesIt) {
    Scene scene = emptyScene(10e9, 0.2, 1.0);
    scene.blocks = {boxBlock("base", {-1, -1}, {4, 0}), boxBlock("plank", {0, 0}, {7, 0.3}),
                    boxBlock("box", {0.2, 0.3}, {1.2, 1.3})};
    Support support;
    support.blockAt = Point(2.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.output.frames = 10;
    scene.stages = {test::settle(), dynamic(3.2, 1e-3)};
    scene.stages.back().initialVelocities = {moving({0.5, 0.8}, {2.0, 0.0})};
    scene.stages.back().integration = Integration::BackwardEuler;  // the box does not vibrate on the plank
    const Both both = runBoth(scene);
    EXPECT_GT(std::abs(both.everything.frames.back().blocks[1].rotation), 0.05);
    EXPECT_LT(awakeShare(both.sleeping), 1.0);
    EXPECT_NEAR(both.sleeping.frames.back().blocks[1].rotation, both.everything.frames.back().blocks[1].rotation, 1e-3);
}

/// Blocks that creep, topple from rest, or lose what holds them, with and without sleep.
class CreepingScenes : public testing::TestWithParam<int> {};

/// A box on a slope at its friction angle, which keeps the speed that it is given [m/s].
Scene creeping(double speed) {
    Scene scene = boxOnBase(30.0, 30.0);
    scene.stages = {test::settle(), dynamic(0.3, 1e-3)};
    scene.stages.back().initialVelocities = {moving({0.5, 0.5}, {speed, 0.0})};
    return scene;
}

/// A box on a slope that is steeper than its friction angle by `more` [°].
Scene sliding(double more) {
    Scene scene = boxOnBase(30.0 + more, 30.0);
    scene.stages = {dynamic(0.5, 1e-3)};
    return scene;
}

/// A column of 1 m × 4 m whose centre is `beyond` [m] past the edge of its base.
Scene toppling(double beyond) {
    Scene scene = emptyScene(10e9, 0.2, 60.0);
    scene.blocks = {boxBlock("base", {-1, -1}, {0.5 - beyond, 0}), boxBlock("column", {0, 0}, {1, 4})};
    Support support;
    support.blockAt = Point(-0.5, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.stages = {dynamic(1.0, 1e-3)};
    scene.output.frames = 5;
    return scene;
}

/// A block that hangs from two bolts. The load on it, after it has come to rest, is more than their bonds carry.
Scene hanging() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("roof", {0, 1}, {4, 3}), boxBlock("hangs", {1, 0}, {3, 1})};
    Support support;
    support.blockAt = Point(2.0, 2.0);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::PeakResidual, 84.78e6, 24.56e3, 2.24e3)};
    type.name = "bar";
    scene.boltTypes = {type};
    for (const double x : {1.4, 2.6}) {
        Bolt bolt;
        bolt.name = "at " + std::to_string(x);
        bolt.type = "bar";
        bolt.farEnd = {x, 2.5};
        bolt.head = {x, 0.1};
        bolt.divisions = 24;
        scene.bolts.push_back(bolt);
    }
    scene.stages = {test::settle(), dynamic(0.4, 1e-3)};
    scene.stages.back().loads = {forceAt({2.0, 0.5}, {0.0, -400e3}, {{0.0, 0.0}, {0.15, 0.0}, {0.35, 1.0}})};
    scene.output.frames = 5;
    return scene;
}

/// A box that slides into another one, which has come to rest on the base.
Scene bumping() {
    Scene scene = boxOnBase(0.0, 20.0);
    scene.blocks.push_back(boxBlock("rests", {2, 0}, {3, 1}));
    scene.stages = {dynamic(1.0, 1e-3)};
    scene.stages.back().initialVelocities = {moving({0.5, 0.5}, {2.5, 0.0})};
    return scene;
}

constexpr int moveAllTheTime = 7;  // of the following scenes; in the others, something sleeps

Scene creepingScene(int number) {
    switch (number) {
        case 0: return creeping(1e-3);
        case 1: return creeping(3e-4);
        case 2: return creeping(1e-4);
        case 3: return sliding(0.01);
        case 4: return sliding(0.1);
        case 5: return toppling(1e-3);
        case 6: return toppling(1e-2);
        case 7: return toppling(-1e-3);
        case 8: return hanging();
        default: return bumping();
    }
}

TEST_P(CreepingScenes, HaveTheSameEventsAndPlaces) {
    const Both both = runBoth(creepingScene(GetParam()));
    EXPECT_EQ(eventsOf(both.everything), eventsOf(both.sleeping));
    if (GetParam() < moveAllTheTime) EXPECT_EQ(awakeShare(both.sleeping), 1.0);
    else EXPECT_LT(awakeShare(both.sleeping), 0.8);
    double moved = 0.0;
    for (const BlockState& block : both.everything.frames.back().blocks)
        moved = std::max(moved, block.displacement.norm());
    EXPECT_LT(apart(both), std::max(1e-7, 1e-3 * moved)) << moved;
}

INSTANTIATE_TEST_SUITE_P(Sleep, CreepingScenes, testing::Range(0, 10));

}  // namespace
}  // namespace keyblock
