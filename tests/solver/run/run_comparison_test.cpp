// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block that a bolt holds is compared with the same block under a bolt that breaks.
#include "solver/results/run_comparison.h"

#include "solver/results/bolt_design.h"
#include "solver/results/settled_blocks.h"
#include "solver/run/run.h"
#include "tests/solver/run/held_block.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace test;

constexpr double strong = 100e3, weak = 15e3;  // [N]; the block weighs 26.5 kN

/// Gravity along the bolt: at equilibrium the bolt carries the weight, and its elements across the joint the same force.
TEST(BoltDesign, OfAHeldBlockCarriesItsWeight) {
    const Solved solved = solve(heldBlock(barOfStrength(strong), elastic()));
    const MemoryRun run(solved.scene, solved.results);
    const BoltDesign design = boltDesigns(run, run.frames().size() - 1).at(0);
    ASSERT_EQ(design.carries.size(), 1U);
    EXPECT_EQ(design.carries[0].block, 1);
    EXPECT_NEAR(design.carries[0].weight, heldWeight, 1e-9 * heldWeight);
    EXPECT_NEAR(design.carries[0].force, heldWeight, 1e-3 * heldWeight);
    EXPECT_NEAR(design.now.axial, heldWeight, 1e-3 * heldWeight);
    EXPECT_NEAR(*design.yieldUse, heldWeight / strong, 1e-3);
    EXPECT_EQ(design.status, BoltStatus::Intact);
    EXPECT_EQ(design.debondedLength, 0.0);
}

TEST(RunComparison, NamesTheBlockAndTheBoltThatHoldsIt) {
    const Solved falls = solve(heldBlock(barOfStrength(weak), elastic()));
    const Solved stable = solve(heldBlock(barOfStrength(strong), elastic()));
    const MemoryRun a(falls.scene, falls.results), b(stable.scene, stable.results);
    const RunComparison found = compareRuns(a, b);
    EXPECT_EQ(found.shared, 2U);
    EXPECT_EQ(found.onlyA + found.onlyB, 0U);
    ASSERT_EQ(found.saved.size(), 1U);
    EXPECT_TRUE(found.saved[0].fallsInA);
    EXPECT_EQ(found.saved[0].block.b, 1);
    ASSERT_EQ(found.saved[0].heldBy.size(), 1U);
    EXPECT_EQ(found.saved[0].heldBy[0].bolt, 0);
    EXPECT_NEAR(found.saved[0].heldBy[0].force, heldWeight, 1e-3 * heldWeight);
    EXPECT_EQ(found.saved[0].heldBy[0].on, 1);
    ASSERT_EQ(found.bolts.size(), 1U);
    EXPECT_TRUE(found.bolts[0].a && found.bolts[0].b);
    const RunComparison reversed = compareRuns(b, a);
    ASSERT_EQ(reversed.saved.size(), 1U);
    EXPECT_FALSE(reversed.saved[0].fallsInA);
}

/// Without the bolt the block falls; a block of another outline is not the same block.
TEST(RunComparison, MatchesBlocksByTheirOutlines) {
    Scene without = heldBlock(barOfStrength(strong), elastic());
    std::swap(without.blocks[0], without.blocks[1]);  // another order
    without.bolts.clear();
    without.monitors.clear();
    without.blocks.push_back(boxBlock("loose", {1, 5}, {2, 6}));
    const Solved falls = solve(without);
    const Solved stable = solve(heldBlock(barOfStrength(strong), elastic()));
    const MemoryRun a(stable.scene, stable.results), b(falls.scene, falls.results);
    const RunComparison found = compareRuns(a, b);
    EXPECT_EQ(found.shared, 2U);
    EXPECT_EQ(found.onlyB, 1U);
    ASSERT_EQ(found.saved.size(), 1U);
    EXPECT_EQ(found.saved[0].block.a, 1);
    EXPECT_EQ(found.saved[0].block.b, 0);
    EXPECT_EQ(found.saved[0].heldBy.size(), 1U);
    EXPECT_FALSE(found.bolts.at(0).b);
    EXPECT_EQ(found.blocks.size(), 2U);
    EXPECT_GT(found.blocks[0].size(), found.blocks[1].size());
}

TEST(RunComparison, OfARunWithItselfIsEmpty) {
    const Solved solved = solve(heldBlock(barOfStrength(weak), elastic()));
    const MemoryRun run(solved.scene, solved.results);
    const RunComparison found = compareRuns(run, run);
    EXPECT_TRUE(found.saved.empty());
    for (const BlockDifference& block : found.blocks) EXPECT_EQ(block.size(), 0.0);
}

/// A block listed in an earlier stage has settled if it is near its position and no longer unstable at the end.
TEST(SettledBlocks, AreAtRestNearTheirPositions) {
    Solved solved = solve(heldBlock(barOfStrength(strong), elastic()));
    UnstableBlock moving;
    moving.block = 1;
    solved.results.stages.push_back(solved.results.stages.back());
    solved.scene.stages.push_back(solved.scene.stages.back());
    solved.results.stages.front().unstable = {moving};
    const auto settled = [&solved] {
        const MemoryRun run(solved.scene, solved.results);
        return settledBlocks(run, verdictOf(run.stages(), run.scene()));
    };
    EXPECT_EQ(settled(), std::vector<int>{1});
    solved.results.frames.back().blocks[1].centroid.x() += 0.2;  // its size is 0.7 m
    EXPECT_TRUE(settled().empty());
    solved.results.frames.back().blocks[1].centroid.x() -= 0.2;
    solved.results.stages.back().unstable = {moving};
    EXPECT_TRUE(settled().empty());
}

}  // namespace
}  // namespace keyblock
