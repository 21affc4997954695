// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The joints and bolts that a verdict names.
#include "solver/run/failed_parts.h"

#include "solver/run/run.h"
#include "tests/solver/run/held_block.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

using namespace test;

TEST(FailedParts, ABrokenBoltAndTheJointThatOpens) {
    const Solved solved = solve(heldBlock(barOfStrength(15e3), elastic()));
    ASSERT_EQ(solved.results.stages.at(0).outcome, Outcome::Collapse);
    const MemoryRun run(solved.scene, solved.results);
    const FailedParts parts = failedParts(run, verdictOf(run.stages(), run.scene()));
    ASSERT_EQ(parts.joints.size(), 1U);
    EXPECT_EQ(parts.joints[0].blockA, 1);
    EXPECT_EQ(parts.joints[0].blockB, 0);
    EXPECT_TRUE(parts.joints[0].opened);
    EXPECT_GT(parts.joints[0].opening, 0.1);
    ASSERT_EQ(parts.bolts.size(), 1U);
    EXPECT_EQ(parts.bolts[0].event, EventKind::TensileRupture);
    const BoltUse use = boltUses(run).at(0);
    EXPECT_GE(share(use, BoltStrength::Steel), 1.0 - 1e-6);
    EXPECT_EQ(use.governs, BoltStrength::Steel);
}

/// A loose block falls, so no equilibrium is found; a bolt whose strength its own block passes breaks all the same, and
/// both blocks are named.
TEST(FailedParts, ABoltThatBreaksBesideABlockThatFalls) {
    Scene scene = heldBlock(barOfStrength(15e3), elastic());
    scene.blocks.push_back(boxBlock("loose", {1, 5}, {2, 6}));
    const Solved solved = solve(scene);
    const StageResult& result = solved.results.stages.at(0);
    ASSERT_EQ(result.outcome, Outcome::Collapse);
    EXPECT_TRUE(std::ranges::count(result.blocks, 1) && std::ranges::count(result.blocks, 2)) << result.message;
    const MemoryRun run(solved.scene, solved.results);
    const FailedParts parts = failedParts(run, verdictOf(run.stages(), run.scene()));
    ASSERT_EQ(parts.bolts.size(), 1U);
    EXPECT_EQ(parts.bolts[0].event, EventKind::TensileRupture);
    EXPECT_EQ(solved.results.events.back().kind, EventKind::Collapse);
}

/// The same with a bolt that holds its block: only the loose one is named.
TEST(FailedParts, ABoltThatHoldsBesideABlockThatFalls) {
    Scene scene = heldBlock(barOfStrength(100e3), elastic());
    scene.blocks.push_back(boxBlock("loose", {1, 5}, {2, 6}));
    const Solved solved = solve(scene);
    EXPECT_EQ(solved.results.stages.at(0).blocks, std::vector<int>{2});
    EXPECT_EQ(solved.results.events.size(), 1U);
}

TEST(FailedParts, ABoltThatHasDebondedOnOneSide) {
    const Anchor weak = anchorRange(Per::Node, AnchorLaw::PeakResidual, 100e6, 4e3, 0.1e3);
    const Solved solved = solve(heldBlock(barOfStrength(200e3), weak));
    ASSERT_EQ(solved.results.stages.at(0).outcome, Outcome::Collapse);
    const MemoryRun run(solved.scene, solved.results);
    const FailedParts parts = failedParts(run, verdictOf(run.stages(), run.scene()));
    const auto debonded = std::ranges::find_if(
        parts.bolts, [](const FailedBolt& bolt) { return bolt.event == EventKind::Debonding; });
    ASSERT_NE(debonded, parts.bolts.end());
    EXPECT_EQ(debonded->bolt, 0);
    EXPECT_EQ(boltUses(run).at(0).governs, BoltStrength::Bond);
    EXPECT_GE(share(boltUses(run).at(0), BoltStrength::Bond), 1.0 - 1e-6);
}

TEST(FailedParts, NothingFailsWhereTheBlockIsHeld) {
    const Solved solved = solve(heldBlock(barOfStrength(100e3), elastic()));
    const MemoryRun run(solved.scene, solved.results);
    const FailedParts parts = failedParts(run, verdictOf(run.stages(), run.scene()));
    EXPECT_TRUE(parts.joints.empty());
    EXPECT_TRUE(parts.bolts.empty());
}

/// A box slides down a slope: the joint below it slips and stays closed.
TEST(FailedParts, AJointThatSlides) {
    Scene scene = test::boxOnBase(45.0, 20.0);
    scene.stages = {test::settle()};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.at(0).outcome, Outcome::Collapse);
    const MemoryRun run(solved.scene, solved.results);
    const FailedParts parts = failedParts(run, verdictOf(run.stages(), run.scene()));
    ASSERT_EQ(parts.joints.size(), 1U);
    EXPECT_FALSE(parts.joints[0].opened);
    EXPECT_GT(parts.joints[0].slip, 0.5);
    EXPECT_LT(parts.joints[0].opening, 0.1);
}

}  // namespace
}  // namespace keyblock
