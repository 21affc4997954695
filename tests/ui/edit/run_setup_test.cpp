// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an imported drawing needs before it can be run, and the in-situ stress from
// depth or principal stresses.
#include "ui/edit/run_setup.h"
#include "ui/edit/stress_edit.h"
#include "ui/edit/defaults.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

Scene drawnSection() {
    Scene scene;
    scene.materials = {{"rock", {2700.0, 50e9, 0.25}}};
    scene.domain.emplace().material = "rock";
    scene.domain->boundary = {{-10.0, -10.0}, {10.0, -10.0}, {10.0, 10.0}, {-10.0, 10.0}};
    SceneTunnel& tunnel = scene.tunnels.emplace_back();
    tunnel.name = "drift";
    tunnel.profile = ProfileKind::Circle;
    tunnel.diameter = 4.0;
    Bolt& bolt = scene.bolts.emplace_back();
    bolt.name = "B1";
    bolt.head = {0.0, 2.0};
    bolt.farEnd = {0.0, 4.4};
    return scene;
}

TEST(RunSetup, AddsSupportsStagesAndInstallsBoltsOnWalls) {
    const Edit edit = withRunSetup(drawnSection());
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.supports.size(), 3u);
    ASSERT_EQ(edit.scene.stages.size(), 3u);
    EXPECT_EQ(edit.scene.stages[1].excavate, std::vector<std::string>{"drift"});
    EXPECT_EQ(edit.scene.stages[2].install, std::vector<std::string>{"B1"});
    EXPECT_EQ(edit.scene.stages[1].relaxation, 0.5);
}

TEST(RunSetup, KeepsExistingSupportsAndStages) {
    Scene scene = withRunSetup(drawnSection()).scene;
    scene.stages.pop_back();
    scene.supports.pop_back();
    EXPECT_EQ(withRunSetup(scene).scene, scene);
    EXPECT_EQ(withRunSetup(Scene{}).scene, Scene{});
}

TEST(StressEdits, DepthAndK0GiveTheOverburdenStress) {
    const Edit edit = withDepthStress(drawnSection(), {110.0, 27e3, 1.5});
    ASSERT_TRUE(edit.done());
    const InSituStress& stress = *edit.scene.inSituStress;
    EXPECT_DOUBLE_EQ(stress.referenceY, 0.0);
    EXPECT_DOUBLE_EQ(stress.syy, -27e3 * 110.0);
    EXPECT_DOUBLE_EQ(stress.sxx, 1.5 * stress.syy);
    EXPECT_DOUBLE_EQ(stress.syy + 110.0 * stress.gradientY.syy, 0.0) << "no stress at the surface";
    const DepthStress again = suggestedDepthStress(edit.scene);
    EXPECT_DOUBLE_EQ(again.surfaceY, 110.0);
    EXPECT_DOUBLE_EQ(again.k0, 1.5);
    EXPECT_FALSE(withDepthStress(drawnSection(), {5.0, 27e3, 1.0}).done()) << "the rock rises above the surface";
    EXPECT_FALSE(withDepthStress(Scene{}, {5.0, 27e3, 1.0}).done());
}

TEST(StressEdits, PrincipalStressesAreConvertedToComponentsAndBack) {
    const Edit edit = withPrincipalStresses(drawnSection(), {20e6, 8e6, 30.0});
    ASSERT_TRUE(edit.done());
    const InSituStress& stress = *edit.scene.inSituStress;
    EXPECT_NEAR(stress.sxx, -17e6, 1e-3);
    EXPECT_NEAR(stress.syy, -11e6, 1e-3);
    EXPECT_EQ(stress.gradientY, StressGradient{});
    const PrincipalStresses back = principalStressesOf(edit.scene);
    EXPECT_NEAR(back.major, 20e6, 1e-3);
    EXPECT_NEAR(back.minor, 8e6, 1e-3);
    EXPECT_NEAR(back.angle, 30.0, 1e-9);
    EXPECT_FALSE(withPrincipalStresses(drawnSection(), {8e6, 20e6, 0.0}).done());
}

}  // namespace
}  // namespace keyblock
