// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/captions.h"

#include "tests/ui/bricks.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(Captions, NameTheStageOnceAndShortenShortTimes) {
    Scene scene = test::bricks();
    scene.title = "Drift";
    Results results;
    results.frames.push_back(test::frameOf(scene, 0.0, 1.0));
    results.frames.back().time = 0.004;
    const auto titled = [&](const std::string& stage) {
        scene.stages.front().name = stage;
        return titleOf(MemoryRun(scene, results), 0);
    };
    scene.stages.front().kind = StageKind::Dynamic;
    EXPECT_EQ(titled("lift"), "Drift, stage lift at 0.004 s");
    EXPECT_EQ(titled("stage 4"), "Drift, stage 4 at 0.004 s");
    EXPECT_EQ(shortTimeText(scene, 0, 0.00395), "3.95 ms");
    EXPECT_EQ(shortTimeText(scene, 0, 0.212), "0.212 s");
    scene.stages.front().kind = StageKind::Static;
    EXPECT_EQ(shortTimeText(scene, 0, 0.05), "0.05");
    EXPECT_EQ(titled("stage 4"), "Drift, stage 4 at pseudo-time 0.004");
}

TEST(Captions, NameTheIntegrationSchemeOfScenesInMotion) {
    Scene scene = test::bricks();
    scene.stages.front().kind = StageKind::Static;
    EXPECT_EQ(analysisText(scene), "plane strain · preset engineering");
    scene.stages.front().kind = StageKind::Dynamic;
    scene.analysis.integration = Integration::Shi;
    EXPECT_EQ(analysisText(scene), "plane strain · Shi scheme · preset engineering");
    scene.analysis.integration = Integration::BackwardEuler;
    EXPECT_EQ(analysisText(scene), "plane strain · backward Euler scheme · preset engineering");
}

}  // namespace
}  // namespace keyblock
