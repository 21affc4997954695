// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One block by itself: its mass, its displacement function, its turning frame.
#include "solver/engine/model/state.h"
#include "solver/engine/setup/make_model.h"

#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

/// A concave block away from the origin.
Scene oddBlock() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    Block block = boxBlock("odd", {0, 0}, {1, 1});
    block.points = {{3.0, 1.0}, {5.0, 1.2}, {4.8, 2.5}, {4.0, 1.6}, {3.1, 2.2}};
    scene.blocks = {block};
    scene.analysis.thickness = 0.7;
    return scene;
}

Vector6 small(double h, int which) {
    Vector6 d = Vector6::Zero();
    d[which] = h;
    return d;
}

/// ∫ρ TᵀT dA over a fan of signed triangles, each by the three middles of its sides: exact for squares.
Matrix6 massByTriangles(const BlockMotion& motion, double densityTimesThickness) {
    Matrix6 mass = Matrix6::Zero();
    const std::vector<Point>& c = motion.corners;
    for (std::size_t i = 1; i + 1 < c.size(); ++i) {
        const double area = 0.5 * cross(c[i] - c[0], c[i + 1] - c[0]);
        for (const Point& twice : {Point(c[0] + c[i]), Point(c[i] + c[i + 1]), Point(c[0] + c[i + 1])}) {
            const auto t = displacementMatrix(motion, 0.5 * twice);
            mass += area / 3.0 * densityTimesThickness * t.transpose() * t;
        }
    }
    return mass;
}

TEST(Block, MassIsTheIntegralOverItsArea) {
    const Model model = makeModel(oddBlock());
    const State state = makeState(model);
    const Matrix6 expected = massByTriangles(state.blocks[0], 2700.0 * 0.7);
    EXPECT_LT((model.blocks[0].massMatrix - expected).cwiseAbs().maxCoeff(), 1e-12 * expected(0, 0));
    EXPECT_NEAR(model.blocks[0].mass, expected(0, 0), 1e-12 * expected(0, 0));
}

TEST(Block, DisplacementMatrixIsTheDerivativeOfTheMove) {
    const Model model = makeModel(oddBlock());
    BlockMotion motion = makeState(model).blocks[0];
    turnUnknowns(motion, {1.0, 2.0});
    moveBlock(model.blocks[0], motion, (Vector6() << 0.3, -0.2, 0.9, 0.01, -0.02, 0.03).finished());
    const Point place{0.4, -0.3};
    const auto t = displacementMatrix(motion, materialPoint(motion, place));
    constexpr double h = 1e-5;
    for (int i = 0; i < 6; ++i) {
        BlockMotion ahead = motion, behind = motion;
        moveBlock(model.blocks[0], ahead, small(h, i));
        moveBlock(model.blocks[0], behind, small(-h, i));
        const Point slope = (materialPoint(ahead, place) - materialPoint(behind, place)) / (2.0 * h);
        EXPECT_LT((slope - t.col(i)).norm(), 1e-9) << i;
    }
}

TEST(Block, PlaceAndPointAreInverse) {
    const Model model = makeModel(oddBlock());
    BlockMotion motion = makeState(model).blocks[0];
    moveBlock(model.blocks[0], motion, (Vector6() << 0.3, -0.2, 0.9, 1e-3, -2e-3, 3e-3).finished());
    const Point place{0.4, -0.3};
    EXPECT_LT((materialPlace(motion, materialPoint(motion, place)) - place).norm(), 1e-14);
}

TEST(Block, FullTurnKeepsAreaAndStress) {
    const Model model = makeModel(oddBlock());
    State state = makeState(model);
    BlockMotion& motion = state.blocks[0];
    moveBlock(model.blocks[0], motion, (Vector6() << 0, 0, 0, 1e-4, -2e-4, 3e-4).finished());
    const Eigen::Vector3d stress = frameStress(model.blocks[0], motion);
    const std::vector<Point> corners = motion.corners;
    constexpr int steps = 1000;
    for (int i = 0; i < steps; ++i) moveBlock(model.blocks[0], motion, small(2.0 * std::numbers::pi / steps, 2));
    EXPECT_EQ(frameStress(model.blocks[0], motion), stress);
    for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_LT((motion.corners[i] - corners[i]).norm(), 1e-12);
}

TEST(Block, TurningTheUnknownsKeepsVelocityAndPlace) {
    const Model model = makeModel(oddBlock());
    BlockMotion motion = makeState(model).blocks[0];
    motion.velocity << 3.0, -1.0, 0.5, 0.1, 0.2, 0.3;
    const Point velocity = centroidVelocity(motion), centroid = motion.centroid;
    turnUnknowns(motion, {-2.0, 0.7});
    EXPECT_LT((centroidVelocity(motion) - velocity).norm(), 1e-15);
    EXPECT_EQ(motion.centroid, centroid);
    EXPECT_EQ(motion.velocity.tail<4>(), Eigen::Vector4d(0.5, 0.1, 0.2, 0.3));
    EXPECT_NEAR(motion.axis.norm(), 1.0, 1e-15);
    moveBlock(model.blocks[0], motion, small(0.1, 0));
    EXPECT_LT((motion.centroid - centroid - 0.1 * Point(-2.0, 0.7).normalized()).norm(), 1e-14);
}

}  // namespace
}  // namespace keyblock
