// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts installed early and late in a deep drift: what they carry against the
// convergence that is left to them, and against a bar on springs in Kirsch's rock.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

Scene drift() {
    const SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/deep-drift.json");
    EXPECT_TRUE(reading.scene);
    return reading.scene.value_or(Scene{});
}

/// Force of largest magnitude along each bolt of a row at the end [N].
std::array<double, 3> forcesOf(const Frame& frame, int row) {
    std::array<double, 3> forces{};
    for (int bolt = 0; bolt < 3; ++bolt)
        for (const BoltNodeFrame& node : frame.bolts[3 * row + bolt].nodes)
            forces[bolt] = std::max(forces[bolt], node.axialForce);
    return forces;
}

/// Displacement of the wall towards the opening at the end of a stage [m].
double wallAt(const Results& results, int stage) {
    double wall = 0.0;
    for (const HistoryRow& row : results.history)
        if (row.stage <= stage) wall = -row.values[3];  // after three forces, ux
    return wall;
}

/// Rock and bolts are linear, so that a bolt takes its share of all that is left but for what bolts hold back: a bar
/// of 67 MN on 2.4 m against 50 GPa.
TEST(DeepDrift, BoltsShareTheConvergenceThatIsLeft) {
    const Results results = runInMemory(drift());
    for (const StageResult& stage : results.stages) ASSERT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
    const double all = wallAt(results, 3);
    EXPECT_NEAR(wallAt(results, 1), 0.3 * all, 2e-3 * all);
    EXPECT_NEAR(wallAt(results, 2), 0.6 * all, 2e-3 * all);
    EXPECT_EQ(wallAt(results, 0), 0.0);
    const Frame& end = results.frames.back();
    for (std::size_t bolt = 0; bolt < 3; ++bolt) {
        const double early = forcesOf(end, 0)[bolt];
        EXPECT_GT(early, 10e3);
        EXPECT_NEAR(forcesOf(end, 1)[bolt] / early, 0.7, 2e-3);
        EXPECT_NEAR(forcesOf(end, 2)[bolt] / early, 0.4, 2e-3);
    }
}

/// Joints that only rub slip the more the less the walls are held: late bolts get a larger share than in elastic rock,
/// and still less than early ones.
TEST(DeepDrift, LateBoltsTakeLessWhereJointsSlipToo) {
    Scene scene = drift();
    JointMaterial& joint = scene.jointMaterials.front().second;
    joint.cohesion = joint.tensileStrength = 0.0;
    const Results results = runInMemory(scene);
    for (const StageResult& stage : results.stages) ASSERT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
    const Frame& end = results.frames.back();
    for (std::size_t bolt = 0; bolt < 3; ++bolt) {
        const double early = forcesOf(end, 0)[bolt], middle = forcesOf(end, 1)[bolt], late = forcesOf(end, 2)[bolt];
        EXPECT_GT(early, 1.1 * middle);
        EXPECT_GT(middle, 1.1 * late);
        EXPECT_GE(late / early, 0.4);
        EXPECT_GE(middle / early, 0.7);
    }
}

/// Force in a D-bolt of 2.4 m between its second and third anchors, the rock at each anchor moving as Kirsch says [N].
double boltInKirschsRock() {
    constexpr double youngs = 50e9, poisson = 0.2, stress = 20e6, radius = 2.5, length = 2.4;
    constexpr std::array<double, 5> place{0.1, 0.43, 1.23, 1.8, length}, spring{84.78e6, 84.78e6, 84.78e6, 84.78e6, 1e9};
    const double bar = 490e6 / 0.0023 * 0.25 * std::numbers::pi * 0.02 * 0.02;
    Eigen::Matrix<double, 5, 5> stiffness = Eigen::Matrix<double, 5, 5>::Zero();
    Eigen::Vector<double, 5> load;
    for (int i = 0; i < 5; ++i) {
        const std::size_t at = i;
        const double inward = (1.0 + poisson) / youngs * stress * radius * radius / (radius + length - place[at]);
        stiffness(i, i) += spring[at];
        load[i] = spring[at] * inward;
        if (i == 0) continue;
        const double k = bar / (place[at] - place[at - 1]);
        stiffness.block<2, 2>(i - 1, i - 1) += k * Eigen::Matrix2d{{1, -1}, {-1, 1}};
    }
    const Eigen::Vector<double, 5> moved = stiffness.fullPivLu().solve(load);
    return bar / (place[2] - place[1]) * (moved[2] - moved[1]);
}

TEST(DeepDrift, NamesWhatABarInKirschsRockCarries) {
    const double whole = boltInKirschsRock();
    const std::array<double, 3> left{1.0, 0.7, 0.4};
    const Scene scene = drift();
    ASSERT_EQ(scene.about.expected.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(scene.about.expected[i].value, left[i] * whole, 1.0);
}

}  // namespace
}  // namespace keyblock
