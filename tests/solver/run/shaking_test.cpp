// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shaking in the ground's frame against a ground that really moves, and against
// what a free body does.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using test::dynamic;

constexpr double step = 1e-3;

Monitor pointMonitor(const std::string& name, const Point& at) {
    Monitor monitor;
    monitor.name = name;
    monitor.point = at;
    return monitor;
}

Support heldAt(const Point& point, Fix fix) {
    Support support;
    support.point = point;
    support.fix = fix;
    return support;
}

/// A box on a table that can only go along x: the slab is prescribed along x and held in y.
Scene tableScene(int steps, const Table& motionOfTheTable) {
    Scene scene = emptyScene(60e9, 0.25, 15.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("table", {-3, -1}, {3, 0}), boxBlock("box", {-0.5, 0}, {0.5, 0.5})};
    scene.supports = {heldAt({-3, -1}, Fix::Y), heldAt({3, -1}, Fix::Y)};
    scene.monitors = {pointMonitor("table", {0, -0.5}), pointMonitor("box", {0, 0.25})};
    scene.stages = {dynamic(steps * step, step)};
    Motion motion;
    motion.blockAt = {0.0, -0.4};
    motion.table = motionOfTheTable;
    scene.stages[0].motions = {motion};
    scene.output.every = 0.01;
    return scene;
}

/// Acceleration of the ground at every step; still at first, so that nothing starts with a jerk.
Table groundAcceleration(int steps) {
    Table record;
    for (int i = 0; i <= steps; ++i)
        record.emplace_back(step * i, i < 5 ? 0.0 : 4.0 * std::sin(2.0 * std::numbers::pi * 2.0 * step * (i - 5)));
    return record;
}

/// The same ground's displacement by Shi's scheme: v⁺ = v + Δt·a, D = ½Δt(v + v⁺).
Table groundDisplacement(const Table& acceleration) {
    Table motion{{0.0, 0.0}};
    double v = 0.0, u = 0.0;
    for (std::size_t i = 1; i < acceleration.size(); ++i) {
        const double next = v + step * acceleration[i].second;
        u += 0.5 * step * (v + next);
        v = next;
        motion.emplace_back(acceleration[i].first, u);
    }
    return motion;
}

/// The ground's frame has no physics of its own: a box slides on a table under base acceleration as it does on one
/// that is moved, seen from the table.
TEST(Shaking, IsThatOfAMovingGround) {
    const int steps = 1000;
    const Table record = groundAcceleration(steps);
    Scene still = tableScene(steps, {{0.0, 0.0}});
    still.stages[0].baseAcceleration.emplace().record = record;
    const Solved shaken = solve(still), moved = solve(tableScene(steps, groundDisplacement(record)));
    EXPECT_EQ(shaken.results.stages[0].steps, steps);
    EXPECT_EQ(moved.results.stages[0].steps, steps);
    const std::vector<double> relative = series(shaken, "box"), box = series(moved, "box"), table = series(moved, "table");
    ASSERT_EQ(relative.size(), box.size());
    double farthest = 0.0;
    for (std::size_t i = 0; i < box.size(); ++i) {
        EXPECT_NEAR(relative[i], box[i] - table[i], 1e-9) << i;
        farthest = std::max(farthest, std::abs(relative[i]));
    }
    EXPECT_GT(farthest, 0.01);  // it did slide
    EXPECT_LT(std::abs(shaken.results.stages[0].health.balanceError), 1e-3);
}

/// A free block under a body acceleration a: u = ½a·t² exactly under Shi's scheme, with no stress, gravity beside it.
TEST(Shaking, AcceleratesAFreeBodyWithoutStress) {
    Scene scene = emptyScene(60e9, 0.25, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.monitors = {pointMonitor("centre", {0.5, 0.5})};
    scene.stages = {dynamic(0.5, step)};
    scene.stages[0].bodyAcceleration.emplace().record = {{0.0, 1.0}, {0.5, 1.0}};
    scene.stages[0].bodyAcceleration->axis = {3.0, 4.0};
    scene.stages[0].bodyAcceleration->factor = 2.0;
    const Solved solved = solve(scene);
    EXPECT_NEAR(reading(solved, "last centre.ux"), 0.5 * 1.2 * 0.25, 1e-12);
    EXPECT_NEAR(reading(solved, "last centre.uy"), 0.5 * (1.6 - gravity) * 0.25, 1e-12);
    for (double s : solved.results.frames.back().blocks[0].stress) EXPECT_NEAR(s, 0.0, 1e-6);
    EXPECT_LT(std::abs(solved.results.frames.back().energy.balanceError), 1e-9);
}

/// A record's end is the end of its force: afterwards the body goes on as it is.
TEST(Shaking, EndsWithItsRecordAndItsStage) {
    Scene scene = emptyScene(60e9, 0.25, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.monitors = {pointMonitor("centre", {0.5, 0.5})};
    scene.stages = {dynamic(0.4, step), dynamic(0.1, step)};
    scene.stages[1].name = "after";
    scene.stages[0].bodyAcceleration.emplace().record = {{0.0, 1.0}, {0.1005, 1.0}};  // 100 steps
    const Solved solved = solve(scene);
    const double speed = 0.1;  // 1 m/s² for 0.1 s
    EXPECT_NEAR(reading(solved, "last centre.ux"), 0.5 * speed * 0.1 + speed * 0.4, 1e-12);
    EXPECT_NEAR(solved.results.frames.back().blocks[0].velocity.x(), speed, 1e-12);
}

/// Bolts have mass, too: a bar at rest in a shaken block is shaken with it.
TEST(Shaking, TakesBoltsAlong) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.supports.clear();
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 1e8, std::nullopt, 0.0)};
    addBolt(scene, type, 0.1, 1.9, 20, PlateKind::None);
    scene.stages = {dynamic(0.1, step)};
    scene.stages[0].bodyAcceleration.emplace().record = {{0.0, 5.0}, {0.1, 5.0}};
    scene.stages[0].bodyAcceleration->axis = {0.0, 1.0};
    const Solved solved = solve(scene);
    for (const BlockState& block : solved.results.frames.back().blocks)
        EXPECT_NEAR(block.displacement.y(), 0.5 * 5.0 * 0.01, 1e-9);
    for (const BoltNodeFrame& node : solved.results.frames.back().bolts[0].nodes) {
        EXPECT_NEAR(node.position.y(), 0.5 + 0.5 * 5.0 * 0.01, 1e-9);
        EXPECT_NEAR(node.axialForce, 0.0, 1e-3);
    }
}

/// A step that the program chooses follows the record.
TEST(Shaking, ChoosesAStepThatFollowsTheRecord) {
    Scene scene = emptyScene(60e9, 0.25, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.stages = {dynamic(0.1, step)};
    scene.stages[0].timeStep.reset();
    scene.stages[0].bodyAcceleration.emplace().record = {{0.0, 0.0}, {1e-4, 1.0}, {2e-4, 0.0}};
    EXPECT_NEAR(static_cast<double>(solve(scene).results.stages[0].steps), 1000.0, 1.0);
}

}  // namespace
}  // namespace keyblock
