// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Other ways to the same contacts: the augmented Lagrangian, in which the
// penalty leaves no trace, and the classical open–close iteration.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

using test::box;
using test::boxOnBase;
using test::dynamic;
using test::expectDone;
using test::settle;
using test::weight;

/// Three courses in running bond on a fixed base.
Scene wall() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("base", {-1, -1}, {5, 0})};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const double x = column + 0.5 * (row % 2), y = 0.5 * row;
            scene.blocks.push_back(boxBlock("", {x, y}, {x + 1.0, y + 0.5}));
        }
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    scene.output.frames = 10;
    return scene;
}

double deepest(const Results& results) {
    double depth = 0.0;
    for (const Frame& frame : results.frames)
        for (const ContactFrame& c : frame.contacts)
            if (c.normalForce > 0.0 && frame.step > 0) depth = std::max(depth, std::abs(c.penetration));
    return depth;
}

class Penalties : public testing::TestWithParam<double> {};

TEST_P(Penalties, LeaveNoPenetrationUnderMultipliers) {
    for (Scene scene : {boxOnBase(0.0, 30.0), wall()}) {
        scene.analysis.contact = ContactMethod::AugmentedLagrangian;
        scene.analysis.penaltyRatio = GetParam();
        scene.stages = {settle()};
        const Results results = runInMemory(scene);
        expectDone(results, 1e-6);
        EXPECT_LT(deepest(results), 1.001e-9);
        double carried = 0.0;
        for (const ContactFrame& c : results.frames.back().contacts)
            if (std::min(c.blockA, c.blockB) == 0) carried += c.normalForce;
        double expected = 0.0;
        for (std::size_t i = 1; i < scene.blocks.size(); ++i) expected += results.frames.back().blocks[i].weight;
        EXPECT_NEAR(carried, expected, 1e-6 * expected);
    }
}

/// Pushed short of its friction a box does not give at all; with penalty springs it gives by force over stiffness.
TEST_P(Penalties, LeaveNoElasticSlipUnderMultipliers) {
    for (const bool multipliers : {false, true}) {
        Scene scene = boxOnBase(0.0, 30.0);
        scene.materials[0].second.youngsModulus = rigidRock;
        scene.analysis.contact = multipliers ? ContactMethod::AugmentedLagrangian : ContactMethod::Penalty;
        scene.analysis.penaltyRatio = GetParam();
        scene.stages = {settle()};
        Load push;
        push.blockAt = Point(0.5, 0.5);
        push.at = Point(0.5, 0.0);
        push.force = {0.9 * weight * std::tan(30 * degree), 0.0};
        scene.stages[0].loads = {push};
        const Results results = runInMemory(scene);
        expectDone(results, 1e-2);
        const double elastic = push.force.x() / (2 * scene.analysis.shearRatio * GetParam() * rigidRock);
        if (multipliers) {
            EXPECT_NEAR(box(results).displacement.x(), 0.0, 2e-9);
        } else if (GetParam() == 1.0) {  // under stiffer springs the box itself gives as much
            EXPECT_NEAR(box(results).displacement.x(), elastic, 0.05 * elastic);
        }
    }
}

TEST_P(Penalties, SlideAndStickAlikeUnderMultipliers) {
    for (const auto& [angle, friction] : {std::pair{30.0, 20.0}, {30.0, 29.0}, {30.0, 30.1}}) {
        Scene scene = boxOnBase(angle, friction);
        scene.analysis.contact = ContactMethod::AugmentedLagrangian;
        scene.analysis.penaltyRatio = GetParam();
        scene.stages = {dynamic(0.5, 1e-3)};
        const Results results = runInMemory(scene);
        expectDone(results, 1e-2);
        const double a = gravity * std::max(0.0, std::sin(angle * degree) -
                                                     std::cos(angle * degree) * std::tan(friction * degree));
        EXPECT_NEAR(box(results).displacement.x(), 0.5 * a * 0.25, 1e-3 * 0.5 * a * 0.25 + 1e-7) << friction;
        EXPECT_LT(deepest(results), 1e-8);
    }
}

INSTANTIATE_TEST_SUITE_P(AugmentedLagrangian, Penalties, testing::Values(1.0, 40.0));

/// A knock under multipliers neither bounces up with new energy nor sinks in.
TEST(AugmentedLagrangian, AKnockBringsNoEnergy) {
    Scene scene = boxOnBase(0.0, 30.0);
    for (Point& p : scene.blocks[1].points) p.y() += 0.01;
    scene.analysis.contact = ContactMethod::AugmentedLagrangian;
    scene.stages = {dynamic(0.2, 1e-3)};
    const Results results = runInMemory(scene);
    expectDone(results, 1e-2);
    for (const Frame& frame : results.frames)
        EXPECT_LE(frame.energy.kinetic + frame.energy.strain, frame.energy.external + 1e-6 * weight * 0.01);
}

void expectSameMotion(Scene scene, double tolerance) {
    const Results convex = runInMemory(scene);
    scene.analysis.iteration = Iteration::OpenClose;
    const Results classical = runInMemory(scene);
    expectDone(convex, 1e-2);
    expectDone(classical, 1e-2);
    ASSERT_EQ(convex.frames.back().blocks.size(), classical.frames.back().blocks.size());
    for (std::size_t i = 0; i < convex.frames.back().blocks.size(); ++i) {
        const Point &x = convex.frames.back().blocks[i].displacement, &y = classical.frames.back().blocks[i].displacement;
        EXPECT_LT((x - y).norm(), tolerance * std::max(1e-6, x.norm())) << i;
    }
}

TEST(OpenClose, SlidesLikeTheConvexStep) {
    Scene scene = boxOnBase(30.0, 20.0);
    scene.stages = {dynamic(0.3, 1e-3)};
    expectSameMotion(scene, 1e-6);
}

TEST(OpenClose, SticksLikeTheConvexStep) {
    Scene scene = boxOnBase(30.0, 30.1);
    scene.stages = {dynamic(0.3, 1e-3)};
    expectSameMotion(scene, 1e-3);
}

/// Friction leaves a wall's forces undetermined: places agree to a tenth of its elastic closure of 5e-8 m.
TEST(OpenClose, AWallStandsLikeUnderTheConvexStep) {
    Scene scene = wall();
    scene.stages = {dynamic(0.05, 1e-3)};
    expectSameMotion(scene, 5e-3);
}

/// The limit of a contact that slides follows a push that only the pass itself finds, so that one pass never does: the
/// step is cut until it is too short, the stage fails and names a block.
TEST(OpenClose, AStepThatDoesNotSettleIsAFailure) {
    Scene scene = boxOnBase(40.0, 20.0);
    scene.analysis.iteration = Iteration::OpenClose;
    scene.analysis.maxPasses = 1;
    scene.stages = {settle()};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 1u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Failed);
    EXPECT_EQ(results.stages[0].message, "no step converges near block box");
}

}  // namespace
}  // namespace keyblock
