// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/result_names.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(Words, AStageIsCalledAStageOnce) {
    Scene scene;
    scene.stages.resize(3);
    scene.stages[0].name = "release";
    scene.stages[1].name = "stage 4";
    EXPECT_EQ(stageTitle(scene, 0), "stage release");
    EXPECT_EQ(stageTitle(scene, 1), "stage 4");
    EXPECT_EQ(stageTitle(scene, 2), "");
    EXPECT_EQ(stageTitle(scene, 7), "");
}

}  // namespace
}  // namespace keyblock
