// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The largest forces of bolts over a run, and the use of their strengths.
#include "solver/run/bolt_extremes.h"

#include "tests/solver/run/held_block.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

using namespace test;

TEST(BoltExtremes, SteelUseGrowsWithTheForces) {
    EXPECT_DOUBLE_EQ(steelUse(-0.4, 0.0), 0.4);
    EXPECT_DOUBLE_EQ(steelUse(0.0, -0.3), 0.3);
    EXPECT_NEAR(steelUse(0.6, 1.0 - 0.36), 1.0, 1e-15);  // on the limit N² + M = 1
    EXPECT_NEAR(steelUse(3 * 0.6, 3 * (1.0 - 0.36)), 3.0, 1e-14);
}

TEST(BoltExtremes, AHangingBlockGivesItsWeight) {
    const Solved solved = solve(heldBlock(barOfStrength(100e3), elastic()));
    ASSERT_EQ(solved.results.stages.at(0).outcome, Outcome::Equilibrium);
    const std::vector<BoltUse> uses = boltUses(MemoryRun(solved.scene, solved.results));
    ASSERT_EQ(uses.size(), 1U);
    EXPECT_NEAR(uses[0].extremes.axialForce.value, heldWeight, 2e-3 * heldWeight);
    EXPECT_NEAR(uses[0].extremes.axialForce.at, 0.5, 0.051);  // next to the joint
    EXPECT_EQ(uses[0].extremes.axialForce.stage, 0);
    EXPECT_NEAR(share(uses[0], BoltStrength::Steel), heldWeight / 100e3, 2e-3);
    EXPECT_FALSE(uses[0].use[static_cast<std::size_t>(BoltStrength::Bond)].has_value());
    EXPECT_FALSE(uses[0].use[static_cast<std::size_t>(BoltStrength::Plate)].has_value());
    EXPECT_EQ(uses[0].governs, BoltStrength::Steel);
    EXPECT_EQ(uses[0].holds, std::vector<int>{1});
}

/// A load that comes at once is felt twice at most, between two frames at equal intervals.
TEST(BoltExtremes, APeakBetweenTwoFramesIsKept) {
    Scene scene = heldBlock(barOfStrength(200e3), elastic());
    scene.stages = {test::dynamic(0.02, 1e-4)};
    std::vector<BoltPeak> peaks;
    for (const int frames : {1, 50}) {
        scene.output.frames = frames;
        const Solved solved = solve(scene);
        double framed = 0.0;
        for (const Frame& frame : solved.results.frames)
            for (const BoltNodeFrame& node : frame.bolts[0].nodes) framed = std::max(framed, node.axialForce);
        peaks.push_back(solved.results.frames.back().extremes.at(0).axialForce);
        EXPECT_GE(peaks.back().value, framed);
        EXPECT_GE(framed, 0.995 * peaks.back().value) << frames;  // it has a frame of its own
    }
    EXPECT_EQ(peaks[0], peaks[1]);
    EXPECT_GT(peaks[0].value, 1.2 * heldWeight);
    EXPECT_LT(peaks[0].value, 2.05 * heldWeight);
}

}  // namespace
}  // namespace keyblock
