// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The extremes of blocks over a run, also between its frames.
#include "solver/run/block_extremes.h"

#include "tests/solver/run/held_block.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

using namespace test;

TEST(BlockExtremes, KeepTheLargestAndTheMostTensile) {
    BlockExtremes extremes;
    BlockState block;
    for (const double stress : {-2e6, 3e6, 1e6}) {  // tension positive
        block.stress = {stress, 0.0, 0.0};
        block.velocity = {0.0, -1e-6 * stress};
        addExtreme(block, 1, 0.1, extremes);
    }
    EXPECT_EQ(extremes.sigma1.value, 2e6);
    EXPECT_EQ(extremes.sigma3.value, -3e6);
    EXPECT_EQ(extremes.velocity.value, 3.0);
    EXPECT_EQ(extremes.velocity.stage, 1);
    std::vector<BlockExtremes> rows{extremes};
    forgetDisplacements(rows);
    EXPECT_EQ(rows[0].displacement.stage, -1);
    EXPECT_EQ(rows[0].velocity, extremes.velocity);
}

/// A block that is suddenly loaded swings on its bolt; its frames are rare, its speed is that of every step.
TEST(BlockExtremes, APeakBetweenTwoFramesIsKept) {
    Scene scene = heldBlock(barOfStrength(200e3), elastic());
    scene.stages = {test::dynamic(0.02, 1e-4)};
    std::vector<BlockExtremes> last;
    for (const int frames : {1, 50}) {
        scene.output.frames = frames;
        const Solved solved = solve(scene);
        double framed = 0.0;
        for (const Frame& frame : solved.results.frames) framed = std::max(framed, frame.blocks[1].velocity.norm());
        const Frame& end = solved.results.frames.back();
        ASSERT_EQ(end.blockExtremes.size(), end.blocks.size());
        last.push_back(end.blockExtremes[1]);
        EXPECT_GE(last.back().velocity.value, framed);
        EXPECT_GT(last.back().velocity.value, 1.5 * end.blocks[1].velocity.norm());
        EXPECT_EQ(end.blockExtremes[0].velocity.value, 0.0) << "the fixed block";
    }
    EXPECT_EQ(last[0], last[1]) << "for any number of frames";
}

}  // namespace
}  // namespace keyblock
