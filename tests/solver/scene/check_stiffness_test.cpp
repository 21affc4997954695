// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Warnings of loads and motion that are too large for the stiffness or the time step.
// Each scene passes its threshold by little, and stays silent just below it.
#include "solver/scene/check.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// The first warning about `word`; empty if there is none.
std::string stiffnessWarning(const Scene& scene, const std::string& word) {
    for (const Problem& problem : checkScene(scene))
        if (problem.severity == Severity::Warning && problem.message.find(word) != std::string::npos)
            return problem.pointer;
    return {};
}

Scene restingBox() {
    Scene scene = test::boxOnBase(0.0, 30.0);  // 1 m, E = 10 GPa
    scene.stages = {test::settle()};
    return scene;
}

TEST(CheckStiffness, WarnsOfRockThatItsWeightStrains) {
    Scene scene = restingBox();
    EXPECT_EQ(stiffnessWarning(scene, "strains"), "");
    scene.materials[0].second.youngsModulus = 1.01 * test::weight / 0.01;
    EXPECT_EQ(stiffnessWarning(scene, "strains"), "");
    scene.materials[0].second.youngsModulus = 0.99 * test::weight / 0.01;
    EXPECT_EQ(stiffnessWarning(scene, "strains"), "/analysis/gravity");
}

TEST(CheckStiffness, WarnsOfSoftContacts) {
    Scene scene = restingBox();
    const double limit = test::weight / (2.0 * 0.01 * 10e9);
    scene.analysis.penaltyRatio = 1.01 * limit / 0.4;  // and of contacts that are soft in shear
    EXPECT_EQ(stiffnessWarning(scene, "so soft"), "");
    scene.analysis.penaltyRatio = 0.99 * limit / 0.4;
    EXPECT_EQ(stiffnessWarning(scene, "so soft in shear"), "/analysis/shear_ratio");
    scene.analysis.penaltyRatio = 0.99 * limit;
    EXPECT_EQ(stiffnessWarning(scene, "presses blocks into each other"), "/analysis/penalty_ratio");
}

TEST(CheckStiffness, WarnsOfLoads) {
    Scene scene = restingBox();
    Load load;
    load.along = {Point(0, 1), Point(1, 1)};
    load.pressure = 99e6;
    scene.stages[0].loads = {load};
    EXPECT_EQ(stiffnessWarning(scene, "the load"), "");
    scene.stages[0].loads[0].pressure = 101e6;
    EXPECT_EQ(stiffnessWarning(scene, "the load"), "/stages/0/loads/0");
    scene.analysis.gravity = {0.0, 0.0};
    scene.stages[0].loads[0].pressure = 0.9e-3;
    EXPECT_EQ(stiffnessWarning(scene, "round-off"), "/stages");
}

TEST(CheckStiffness, WarnsOfFastMotion) {
    Scene scene = restingBox();
    scene.stages = {test::dynamic(1.0, 0.1)};
    EXPECT_EQ(stiffnessWarning(scene, "falls by"), "");  // 4.9 % of the box
    scene.stages[0].timeStep = 0.11;
    EXPECT_EQ(stiffnessWarning(scene, "falls by"), "/stages/0/time_step");
    scene.stages[0].timeStep = 1e-3;
    scene.stages[0].initialVelocities = {{{0.5, 0.4}, {30.0, 0.0}, 200.0}};
    EXPECT_EQ(stiffnessWarning(scene, "deforms"), "");
    EXPECT_EQ(stiffnessWarning(scene, "turns by"), "");
    scene.stages[0].initialVelocities = {{{0.5, 0.4}, {40.0, 0.0}, 301.0}};  // 2.1 % of the wave velocity
    EXPECT_EQ(stiffnessWarning(scene, "deforms"), "/stages/0/initial_velocities/0/velocity");
    EXPECT_EQ(stiffnessWarning(scene, "turns by"), "/stages/0/initial_velocities/0/spin");
    scene.stages[0].timeStep = 0.03;
    EXPECT_EQ(stiffnessWarning(scene, "of its size in a time step"), "/stages/0/initial_velocities/0/velocity");
}

}  // namespace
}  // namespace keyblock
