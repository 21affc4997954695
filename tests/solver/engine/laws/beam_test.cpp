// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The beam as a matrix and as three scalar springs: the same thing, without a
// force in any rigid motion.
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/laws/beam.h"
#include "solver/engine/setup/make_model.h"

#include "solver/verify/scenes.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using Matrix = Eigen::Matrix<double, 6, 6>;

BeamSection bar() {
    BeamSection section;
    section.area = barArea();
    section.secondMoment = std::numbers::pi * std::pow(0.02, 4) / 64.0;
    section.youngsModulus = 200e9;
    section.shearModulus = 80e9;
    return section;
}

TEST(Beam, StiffnessIsSymmetricWithThreeRigidModes) {
    for (const bool shears : {false, true}) {
        const double length = 0.3;
        Matrix k = beamStiffness(bar(), length, shears);
        EXPECT_EQ(k, k.transpose());
        Matrix scale = Matrix::Identity();
        scale(2, 2) = scale(5, 5) = 1.0 / length;  // so that all entries are forces per length
        const Eigen::SelfAdjointEigenSolver<Matrix> modes(scale * k * scale);
        const auto& values = modes.eigenvalues();
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(values[i], 0.0, 1e-13 * values[5]);
        for (int i = 3; i < 6; ++i) EXPECT_GT(values[i], 1e-6 * values[5]);
    }
}

TEST(Beam, RigidTurnsOfAnySizeStrainNothing) {
    const double length = 0.4, first = 0.3;
    for (const double turn : {0.5 * std::numbers::pi, std::numbers::pi, -0.5 * std::numbers::pi, 3.0,
                              7.0 * std::numbers::pi, -40.0 * std::numbers::pi + 0.1}) {
        const Point x1{2.0, -1.0};
        const Point along{std::cos(first + turn), std::sin(first + turn)};
        const BeamStrains s = beamStrains({x1, x1 + length * along, turn, turn}, length, first);
        EXPECT_NEAR(s.elongation, 0.0, 1e-15) << turn;
        EXPECT_NEAR(s.p1, 0.0, 1e-13) << turn;
        EXPECT_NEAR(s.p2, 0.0, 1e-13) << turn;
    }
}

/// A bolt of one element in one block, or across a joint.
StepProblem oneElement(bool acrossJoint) {
    Scene scene = twoBlocks(60e9, acrossJoint ? 1.0 : 1.9, 2.0);
    addBolt(scene, linearType(barArea(), 200e9), 0.5, 1.5, 1, PlateKind::None);
    const Model model = makeModel(scene);
    const State state = makeState(model);
    StepProblem problem;
    problem.blocks = 2;
    problem.nodes = 2;
    addBoltLinks(model, state, 0, problem);
    return problem;
}

TEST(Beam, ScalarSpringsAddUpToTheMatrix) {
    for (const bool shears : {false, true}) {
        const StepProblem problem = oneElement(shears);
        Matrix sum = Matrix::Zero();
        for (const Link& link : problem.links) {
            if (link.kind != LinkKind::Axial && link.kind != LinkKind::Bend && link.kind != LinkKind::Shear) continue;
            Vector6 g = Vector6::Zero();
            g.segment<3>(3 * (link.a - 2)) += link.ga.head<3>();
            g.segment<3>(3 * (link.b - 2)) += link.gb.head<3>();
            sum += link.law.share * link.law.stiffness * g * g.transpose();
        }
        const Matrix expected = beamStiffness(bar(), 1.0, shears);
        EXPECT_LT((sum - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
        // the axial stiffness must not hide an error of the bending
        for (const int i : {1, 2, 4, 5})
            for (const int j : {1, 2, 4, 5}) EXPECT_NEAR(sum(i, j), expected(i, j), 1e-9 * expected(1, 1));
    }
}

/// A cantilever from its far end, pushed to its left at the head: shear and moment are positive.
TEST(Beam, SignsOfShearAndMoment) {
    const BeamSection section = bar();
    const double length = 0.5, push = 10.0;
    const Eigen::Matrix2d free = beamStiffness(section, length, false).block<2, 2>(4, 4);
    const Eigen::Vector2d moved = free.inverse() * Eigen::Vector2d(push, 0.0);
    const BeamStrains s = beamStrains({{0.0, 0.0}, {length, moved[0]}, 0.0, moved[1]}, length, 0.0);
    const double ei = section.youngsModulus * section.secondMoment;
    const BeamForces forces = beamForces(2.0 * ei / length * s.p1, 6.0 * ei / length * s.p2, length);
    EXPECT_NEAR(forces.shear, push, 1e-6 * push);
    EXPECT_NEAR(-forces.moment1, push * length, 1e-6 * push * length);  // on the far side of the section at node 1
    EXPECT_NEAR(forces.moment2, 0.0, 1e-6 * push * length);
}

}  // namespace
}  // namespace keyblock
