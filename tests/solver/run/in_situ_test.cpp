// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rock under stress that is in equilibrium stands as it is: not a step is needed,
// and nothing moves.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using test::settle;

constexpr double density = 2700.0;

void holdBlock(Scene& scene, const Point& place) {
    Support support;
    support.blockAt = place;
    scene.supports.push_back(support);
}

/// Walls and floor that do not move, 4 m × 3 m of room between them, its top at y = 0.
Scene room(double frictionAngle) {
    Scene scene = emptyScene(1e10, 0.2, frictionAngle);
    scene.materials[0].second.density = density;
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("floor", {-1, -4}, {5, -3}), boxBlock("west", {-1, -3}, {0, 0}),
                    boxBlock("east", {4, -3}, {5, 0})};
    holdBlock(scene, {2.0, -3.5});
    holdBlock(scene, {-0.5, -1.5});
    holdBlock(scene, {4.5, -1.5});
    const double perMetre = density * gravity;
    scene.inSituStress = InSituStress{-1e5, 0.0, 0.0, {0.8 * perMetre, perMetre, 0.0}, 0.0};
    scene.stages = {settle()};
    return scene;
}

void expectStill(const Scene& scene) {
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
    EXPECT_EQ(solved.results.stages[0].health.steps, 0);
    for (const BlockState& block : solved.results.frames.back().blocks) {
        EXPECT_LT(block.displacement.norm(), 1e-12);
        EXPECT_EQ(block.rotation, 0.0);
    }
    EXPECT_TRUE(solved.results.events.empty());
    EXPECT_LT(std::abs(solved.results.stages[0].health.balanceError), 1e-9);
}

TEST(InSitu, AWallOfBricksStandsUnderItsOwnStress) {
    Scene scene = room(30.0);
    for (int row = 0; row < 3; ++row) {
        const double low = -3.0 + row, shift = row % 2 == 0 ? 0.0 : 0.5;
        for (double x = 0.0; x < 4.0 - 1e-9;) {
            const double next = std::min(4.0, x == 0.0 && shift > 0.0 ? shift : x + 1.0);
            scene.blocks.push_back(boxBlock("", {x, low}, {next, low + 1.0}));
            x = next;
        }
    }
    expectStill(scene);
    Scene stiff = scene;
    stiff.jointMaterials[0].second.normalStiffness = 5e10;
    stiff.jointMaterials[0].second.shearStiffness = 1e10;
    expectStill(stiff);
    Scene augmented = scene;
    augmented.analysis.contact = ContactMethod::AugmentedLagrangian;
    expectStill(augmented);
}

/// Slanting joints that meet in odd points, a triangle and a sliver among them.
TEST(InSitu, OddBlocksStandUnderTheirStress) {
    Scene scene = room(60.0);
    const Point middle(1.7, -1.2), left(0.0, -0.7), right(4.0, -2.1), low(1.1, -3.0), up(2.6, 0.0), upper(2.3, 0.0);
    const auto block = [&](const std::vector<Point>& points) {
        Block b;
        b.points = points;
        b.material = scene.blocks[0].material;
        scene.blocks.push_back(b);
    };
    block({{0.0, -3.0}, low, middle, left});
    block({low, {4.0, -3.0}, right, middle});
    block({middle, right, {4.0, 0.0}, up});
    block({middle, up, upper});
    block({left, middle, upper, {0.0, 0.0}});
    expectStill(scene);
    scene.inSituStress->sxx = -3e5;
    scene.inSituStress->gradientY.sxx = 0.0;
    scene.jointMaterials[0].second.frictionAngle = 85.0;
    expectStill(scene);
}

TEST(InSitu, CellsOfABlockStandUnderTheirStress) {
    Scene scene = room(30.0);
    scene.blocks.push_back(boxBlock("rock", {0, -3}, {4, 0}));
    scene.blocks.back().subBlocks = CellSettings{1.0};
    expectStill(scene);
}

/// Held points carry what the free faces would have to; a roller leaves its own direction free, where nothing acts.
TEST(InSitu, HeldPointsCarryTheStressOfFreeFaces) {
    Scene scene = emptyScene(1e10, 0.2, 30.0);
    scene.blocks = {boxBlock("a", {0, 0}, {1, 1}), boxBlock("b", {1, 0}, {2, 1})};
    const auto hold = [&](const Point& point, Fix fix) {
        Support support;
        support.point = point;
        support.fix = fix;
        scene.supports.push_back(support);
    };
    for (const Point& point : {Point(0, 0), Point(0, 1), Point(2, 0), Point(2, 1)}) hold(point, Fix::X);
    for (const Point& point : {Point(0, 0), Point(1, 0), Point(2, 0), Point(0, 1), Point(1, 1), Point(2, 1)})
        hold(point, Fix::Y);
    scene.blocks[1].points = {{1, 0}, {2, 0}, {2, 1}, {1, 1}};
    scene.inSituStress = InSituStress{-4e6, 0.0, 0.0, {1e5, 0.0, 0.0}, 0.0};
    scene.stages = {settle()};
    expectStill(scene);
}

/// Stress of a block of its own adds to that of the scene.
TEST(InSitu, StressIsThatOfTheCentroid) {
    Scene scene = room(30.0);
    scene.blocks.push_back(boxBlock("rock", {0, -3}, {4, 0}));
    const Solved solved = solve(scene);
    const BlockState& rock = solved.results.frames.front().blocks[3];
    EXPECT_NEAR(rock.stress[1], -1.5 * density * gravity, 1e-6);
    EXPECT_NEAR(rock.stress[0], -1e5 - 0.8 * 1.5 * density * gravity, 1e-6);
}

}  // namespace
}  // namespace keyblock
