// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks that are active, asleep, fixed and removed: a slab that is fixed, one brick
// that moves and one that does not.
#include "ui/picture/section/activity.h"

#include "tests/ui/bricks.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

class ActivityTest : public ::testing::Test {
protected:
    ActivityTest() {
        scene_ = test::bricks();
        Support support;
        support.blockAt = Point(3.5, 0.5);
        scene_.supports = {support};
        Frame first = test::frameOf(scene_, 0.0, 0.0), last = test::frameOf(scene_, 0.1, 0.0);
        last.blocks[1].velocity = {0.0, 1e-12};
        results_.frames = {first, last};
    }

    SectionPicture picture(std::size_t frame, bool activity = true) const {
        const MemoryRun run(scene_, results_);
        const SectionLegends none;
        SectionRequest request;
        request.frame = frame;
        request.activity = activity;
        request.legends = &none;
        return sectionPicture(run, request);
    }

    Scene scene_;
    Results results_;
};

TEST_F(ActivityTest, AllButTheFixedBlockAreActiveBeforeTheFirstStep) {
    const ActivityCounts counts = *picture(0).activity;
    EXPECT_EQ(counts.fixed, 1);
    EXPECT_EQ(counts.active, 2);
    EXPECT_EQ(counts.asleep, 0);
}

TEST_F(ActivityTest, ABlockWithoutVelocityIsAsleepInMotion) {
    const SectionPicture last = picture(1);
    ASSERT_EQ(last.blocks.size(), 3u);
    EXPECT_EQ(last.blocks[0].activity, BlockActivity::Fixed);
    EXPECT_EQ(last.blocks[1].activity, BlockActivity::Active);
    EXPECT_EQ(last.blocks[2].activity, BlockActivity::Asleep);
    EXPECT_EQ(last.activity->removed, 0);
}

TEST_F(ActivityTest, NoBlockIsAsleepInAStaticStage) {
    scene_.stages[0].kind = StageKind::Static;
    EXPECT_EQ(picture(1).activity->asleep, 0);
}

TEST_F(ActivityTest, RemovedBlocksAreCountedAndNotDrawn) {
    results_.frames[1].blocks[2].area = 0.0;
    const SectionPicture last = picture(1);
    EXPECT_EQ(last.activity->removed, 1);
    EXPECT_EQ(last.blocks.size(), 2u);
}

TEST_F(ActivityTest, IsNotShownUnlessRequested) {
    EXPECT_FALSE(picture(1, false).activity);
    EXPECT_FALSE(picture(1, false).blocks[1].activity);
}

}  // namespace
}  // namespace keyblock
