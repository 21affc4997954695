// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One step by itself: the minimum obeys Coulomb, balances, and a body that
// nothing holds is named.
#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/step/step_solver.h"
#include "solver/verify/scenes.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double push = 5e3;  // [N]

/// A box on a fixed base, pushed along the joint.
Scene boxOnBase(double frictionAngle) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("base", {-1, -1}, {2, 0}), boxBlock("box", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    return scene;
}

struct Step {
    Model model;
    State state;
    Loads loads;
    LoadPoint at;
    StepProblem problem;
    Eigen::VectorXd d;
    SolveReport report;

    Step(const Scene& scene, double force, double dt) : model(makeModel(scene)), state(makeState(model)) {
        state.contacts = findContacts(model, state.blocks, {}, 0.01, true);
        placeBolts(model, state);
        loads.forces = {{1, {0.0, 0.0}, {force, 0.0}}};
        at.gravity = 1.0;
        at.forces = {1.0};
        problem = buildStep(model, state, loads, at, {Inertia::Static, dt, false});
        d = Eigen::VectorXd::Zero(problem.unknowns());
        report = StepSolver().solve(problem, d, {1e-10, 40}, {});
    }

    double sum(LinkKind kind) const {
        std::vector<double> strains;
        linkStrains(problem, d, strains);
        double total = 0.0;
        for (std::size_t i = 0; i < strains.size(); ++i)
            if (problem.links[i].kind == kind) total += respond(problem.links[i].law, strains[i]).force;
        return total;
    }
};

TEST(StepSolver, MinimumObeysCoulombAndBalances) {
    for (const double angle : {0.0, 5.0, 30.0, 80.0}) {
        Step step(boxOnBase(angle), push, 0.1);
        ASSERT_TRUE(step.report.converged) << angle;
        EXPECT_LE(step.report.residual, 1e-9);
        const double weight = 2700.0 * gravity, tanPhi = std::tan(angle * std::numbers::pi / 180.0);
        std::vector<double> strains;
        linkStrains(step.problem, step.d, strains);
        for (const LimitPair& pair : step.problem.limitPairs) {
            const auto f = static_cast<std::size_t>(pair.limited), n = static_cast<std::size_t>(pair.from);
            const double normal = -respond(step.problem.links[n].law, strains[n]).force;
            EXPECT_GE(normal, 0.0);
            EXPECT_LE(std::abs(respond(step.problem.links[f].law, strains[f]).force), normal * tanPhi + 1e-6);
        }
        // what friction does not carry accelerates the box: 2M/Δt² at rest
        const double inertia = 2.0 * 2700.0 / (0.1 * 0.1);
        EXPECT_NEAR(-step.sum(LinkKind::Normal), weight - inertia * -step.d[7], 1e-6 * weight) << angle;
        EXPECT_NEAR(std::abs(step.sum(LinkKind::Friction)), push - inertia * step.d[6], 1e-6 * push) << angle;
        if (tanPhi * weight >= push) continue;
        EXPECT_NEAR(std::abs(step.sum(LinkKind::Friction)), tanPhi * weight, 1e-5 * weight) << angle;
    }
}

TEST(StepSolver, ConvergedMeansTheTrueForcesBalance) {
    Step step(boxOnBase(30.0), push, 1e3);
    ASSERT_TRUE(step.report.converged);
    correctFrictionLimits(step.problem, step.d);
    const Eigen::VectorXd net = netForce(step.problem, step.d);
    EXPECT_LE(residualNorm(step.problem, net), 1e-9 * referenceForce(step.problem, step.d, net));
}

/// One block between springs of its own, with a joint that pushes against it and slides: its normal force answers to its
/// friction, as between steep joints of a wedge.
struct SlidingJoint {
    StepProblem problem;
    Eigen::Vector2d normal{-1.0, 0.0}, tangent{0.0, 0.0};
    static constexpr double spring = 1e6, penalty = 1e8, factor = 0.9;  // [N/m], of both bodies; tan φ

    explicit SlidingJoint(double angle) {
        tangent = {std::cos(angle), std::sin(angle)};
        problem.blocks = 1;
        problem.blockStiffness = {spring * Matrix6::Identity()};
        problem.load = Eigen::VectorXd::Zero(6);
        problem.load.head<2>() << 2e3, 5e3;
        problem.known.assign(6, 0);
        problem.value = Eigen::VectorXd::Zero(6);
        problem.weight = Eigen::VectorXd::Ones(6);
        problem.floorForce = 1e-9;
        problem.moves = true;
        problem.ownForce = {1e3};
        problem.links.resize(2);
        Link &n = problem.links[0], &t = problem.links[1];
        n.a = t.a = 0;
        n.kind = LinkKind::Normal;
        t.kind = LinkKind::Friction;
        n.ga.head<2>() = normal;
        t.ga.head<2>() = tangent;
        n.law.kind = LawKind::Gap;
        t.law.kind = LawKind::Capped;
        n.law.stiffness = t.law.stiffness = penalty;
        problem.limitPairs = {{1, 0, factor}};
    }

    /// Where the block comes to while the joint pushes and slides forwards: a linear system without symmetry.
    Eigen::Vector2d sliding() const {
        Eigen::Matrix2d a = spring * Eigen::Matrix2d::Identity() + penalty * normal * normal.transpose();
        a -= factor * penalty * tangent * normal.transpose();
        return a.lu().solve(problem.load.head<2>());
    }
};

TEST(StepSolver, FrictionFollowsTheNormalForceWithinTheStep) {
    for (const double angle : {0.4, 0.8, 1.2, 1.5707963267948966, 2.0, 2.6}) {
        SlidingJoint joint(angle);
        const Eigen::Vector2d expected = joint.sliding();
        if (joint.normal.dot(expected) >= 0.0) continue;  // it opens
        Eigen::VectorXd d = Eigen::VectorXd::Zero(6);
        const SolveReport report = StepSolver().solve(joint.problem, d, {.tolerance = 1e-10}, {});
        ASSERT_TRUE(report.converged) << angle;
        EXPECT_LE(report.passes, 6) << angle;
        const double carried = -joint.penalty * joint.normal.dot(d.head<2>());
        EXPECT_NEAR(joint.problem.links[1].law.limit, joint.factor * carried, 1e-9 * carried) << angle;
        EXPECT_LE((d.head<2>() - expected).norm(), 1e-8 * expected.norm()) << angle;
    }
}

/// The joint slides back while the block is pushed into it, and its friction helps to push: as long as it slides, the
/// resistance spring + penalty·(1 − 1.02) is zero or negative. Balance is only where it sticks.
TEST(StepSolver, AWedgedBlockMovesOnUntilItSticks) {
    SlidingJoint joint(std::numbers::pi);
    constexpr double slip = 0.0404;  // of the joint before the step [m]
    joint.problem.limitPairs[0].factor = 1.02;
    joint.problem.links[1].law.offset = -slip;
    Eigen::VectorXd d = Eigen::VectorXd::Zero(6);
    const SolveReport report = StepSolver().solve(joint.problem, d, {.tolerance = 1e-10}, {});
    ASSERT_TRUE(report.converged);
    EXPECT_LE(report.passes, 15);
    const double sticking = (joint.problem.load[0] + joint.penalty * slip) / (joint.spring + 2.0 * joint.penalty);
    EXPECT_NEAR(d[0], sticking, 1e-8 * sticking);
    EXPECT_LT(joint.penalty * (slip - d[0]), joint.problem.links[1].law.limit);
}

TEST(StepSolver, NamesTheLooseBlock) {
    Scene scene = boxOnBase(30.0);
    scene.materials[0].second.density = 0.0;
    for (Point& p : scene.blocks[1].points) p += Point(0.0, 5.0);  // holds to nothing, and has no mass
    const Step step(scene, push, 1.0);
    EXPECT_FALSE(step.report.converged);
    EXPECT_TRUE(step.report.singular);
    EXPECT_EQ(step.report.worst, 1);
}

TEST(StepSolver, NamesTheLooseNode) {
    Scene scene = boxOnBase(30.0);
    BoltType type = linearType(barArea(), 200e9);
    type.density = 0.0;
    type.bending = Bending::None;  // artificial anchors hold it across only: it slides along itself
    addBolt(scene, type, 0.2, 0.8, 2, PlateKind::None);
    const Step step(scene, push, 1.0);
    EXPECT_TRUE(step.report.singular);
    EXPECT_GE(step.report.worst, 2);
}

TEST(StepSolver, StopsWhenAsked) {
    Step step(boxOnBase(30.0), push, 1.0);
    Eigen::VectorXd d = Eigen::VectorXd::Zero(step.problem.unknowns());
    const SolveReport report = StepSolver().solve(step.problem, d, {1e-10, 40}, [] { return true; });
    EXPECT_TRUE(report.stopped);
    EXPECT_FALSE(report.converged);
}

}  // namespace
}  // namespace keyblock
