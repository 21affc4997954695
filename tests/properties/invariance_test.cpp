// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What must hold for any scene: the number of threads, the place of the origin
// and a mirror change nothing, rest stays rest, and energy does not come from
// nowhere.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

const Point far{1e6, -1e6};

/// Half a dozen bricks that slide and knock.
WallSetting slidingWall() {
    WallSetting wall;
    wall.frictionAngle = 20.0;
    wall.gravity = {9.81 * std::sin(0.5), -9.81 * std::cos(0.5)};
    wall.duration = 0.05;
    return wall;
}

Scene shortRebar() { return paperRebar(213.043e9, 24.56e3, 59, 60e9, 0.001, 20); }

double largestDisplacement(const Frame& frame) {
    double largest = 0.0;
    for (const BlockState& block : frame.blocks) largest = std::max(largest, block.displacement.norm());
    return largest;
}

void expectSameEvents(const Results& found, const Results& expected, double relative) {
    ASSERT_FALSE(expected.events.empty());
    ASSERT_EQ(found.events.size(), expected.events.size());
    for (std::size_t i = 0; i < expected.events.size(); ++i) {
        EXPECT_EQ(found.events[i].kind, expected.events[i].kind) << i;
        EXPECT_EQ(found.events[i].node, expected.events[i].node) << i;
        const double force = expected.events[i].axialForce;
        EXPECT_NEAR(found.events[i].axialForce, force, relative * std::abs(force)) << i;
    }
}

TEST(Threads, ChangeNoBit) {
    WallSetting wall;
    wall.columns = 1200;  // large enough for every loop that is shared out
    wall.rows = 1;
    wall.gravity = {2.0, -9.6};  // held by friction
    wall.duration = 0.003;
    const Scene scene = brickWall(wall);
    const Results one = runInMemory(scene, {1});
    const Results two = runInMemory(scene, {2});
    ASSERT_FALSE(one.frames.empty());
    EXPECT_GT(one.frames.back().contacts.size(), 4096u);
    EXPECT_TRUE(one == two);
}

TEST(Threads, ChangeNoBitOfABolt) {
    const Results one = runInMemory(shortRebar(), {1});
    EXPECT_FALSE(one.events.empty());
    EXPECT_TRUE(one == runInMemory(shortRebar(), {2}));
}

TEST(Translation, KeepsForcesAndOrder) {
    expectSameEvents(runInMemory(moved(shortRebar(), far)), runInMemory(shortRebar()), 1e-6);
}

TEST(Translation, KeepsMotion) {
    const Scene scene = brickWall(slidingWall());  // exact in binary here and there: only round-off differs
    const Frame here = runInMemory(scene).frames.back();
    const Frame there = runInMemory(moved(scene, far)).frames.back();
    const double largest = largestDisplacement(here);
    ASSERT_GT(largest, 1e-3);
    for (std::size_t i = 0; i < here.blocks.size(); ++i)
        EXPECT_LE((here.blocks[i].displacement - there.blocks[i].displacement).norm(), 1e-6 * largest) << i;
}

TEST(Mirror, MirrorsTheMotion) {
    const Scene scene = brickWall(slidingWall());
    const Frame frame = runInMemory(scene).frames.back();
    const Frame mirror = runInMemory(mirrored(scene)).frames.back();
    const double largest = largestDisplacement(frame);
    ASSERT_GT(largest, 1e-3);
    for (std::size_t i = 0; i < frame.blocks.size(); ++i) {
        const Point reflected{-mirror.blocks[i].displacement.x(), mirror.blocks[i].displacement.y()};
        EXPECT_LE((frame.blocks[i].displacement - reflected).norm(), 1e-6 * largest) << i;
        EXPECT_NEAR(frame.blocks[i].rotation, -mirror.blocks[i].rotation, 1e-6 * largest) << i;
    }
}

TEST(Mirror, MirrorsTheOrderOfRelease) {
    expectSameEvents(runInMemory(mirrored(shortRebar())), runInMemory(shortRebar()), 1e-6);
}

TEST(Rest, StaysRest) {
    WallSetting wall;
    wall.duration = 0.2;
    const Results results = runInMemory(brickWall(wall));
    // Without preload the wall would sink by about ρgH²/2E, 1e-6 m; with it only what the pass tolerance leaves moves.
    EXPECT_LT(largestDisplacement(results.frames.back()), 1e-9);
    EXPECT_TRUE(results.events.empty());
}

TEST(Rest, StaysRestOnASlabOfAnyWidth) {
    WallSetting row;
    row.columns = 100;
    row.rows = 1;
    row.duration = 0.01;
    const Results results = runInMemory(brickWall(row));
    EXPECT_LT(largestDisplacement(results.frames.back()), 1e-9);
    EXPECT_TRUE(results.events.empty());
}

TEST(Energy, IsNotCreated) {
    const Results results = runInMemory(brickWall(slidingWall()));
    const Energy energy = results.frames.back().energy;
    EXPECT_GT(energy.friction, 0.0);
    EXPECT_GE(energy.damped, -1e-12 * energy.external);
    EXPECT_LE(energy.kinetic + energy.strain + energy.contact, energy.external * (1.0 + 1e-6));
    EXPECT_LT(std::abs(energy.balanceError), 1e-3);
}

}  // namespace
}  // namespace keyblock
