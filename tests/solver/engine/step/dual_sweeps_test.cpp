// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sweeps over the contact forces: the step that they find is the one that Newton's
// method finds, under every rule for the forces of a step.
#include "solver/engine/step/dual_sweeps.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/balance.h"
#include "solver/engine/step/step_solver.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/verify/scenes.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

/// A wall that begins to slide and tilt from rest, its joints without history.
StepProblem slidingWall(const Model& model, const StepOptions& options) {
    State state = makeState(model);
    placeBolts(model, state);
    state.contacts = findContacts(model, state.blocks, {}, 0.01, true);
    for (std::size_t i = 0; i < state.blocks.size(); ++i)
        if (!model.blocks[i].fixed) state.blocks[i].velocity[0] = 0.01 * static_cast<double>(i);
    LoadPoint at;
    at.gravity = 1.0;
    return buildStep(model, state, Loads{}, at, options);
}

Bolt rebar(const Point& farEnd, const Point& head) {
    Bolt bolt;
    bolt.type = "rebar-20";
    bolt.farEnd = farEnd;
    bolt.head = head;
    bolt.divisions = 12;
    return bolt;
}

/// A plain Gauss–Seidel sweep: for each link in turn, solves for the displacements of both bodies under all other forces
/// and sets its force to the one that fits its law together with the displacement that it causes.
std::vector<double> plainSweep(const StepProblem& problem, const SweptLinks& swept, std::vector<double> forces) {
    const auto compliant = [&](int body, const Vector6& force) -> Vector6 {
        if (body < 0) return Vector6::Zero();
        Matrix6 stiffness = problem.blockStiffness[body];
        Vector6 acting = force;
        for (int k = 0; k < 6; ++k)
            if (problem.known[6 * body + k]) {
                stiffness.row(k).setZero(), stiffness.col(k).setZero();
                stiffness(k, k) = 1.0, acting[k] = 0.0;
            }
        return stiffness.ldlt().solve(acting);
    };
    const auto displaced = [&](int body, std::size_t without) {
        Vector6 force = Vector6::Zero();
        if (body >= 0) force = problem.load.segment<6>(6 * body);
        for (std::size_t m = 0; m < forces.size(); ++m) {
            const Link& link = problem.links[swept.linkOf(m)];
            if (m == without) continue;
            if (link.a == body) force -= link.law.share * forces[m] * link.ga;
            if (link.b == body) force -= link.law.share * forces[m] * link.gb;
        }
        return compliant(body, force);
    };
    for (std::size_t n = 0; n < forces.size(); ++n) {
        const std::size_t i = swept.linkOf(n);
        const Link& link = problem.links[i];
        const double free = link.strain + link.shift + link.ga.dot(displaced(link.a, n)) +
                            (link.b >= 0 ? link.gb.dot(displaced(link.b, n)) : 0.0);
        const double compliance = link.law.share * (link.ga.dot(compliant(link.a, link.ga)) +
                                                    (link.b >= 0 ? link.gb.dot(compliant(link.b, link.gb)) : 0.0));
        const double trial = link.law.stiffness * (free - link.law.offset) / (1.0 + link.law.stiffness * compliance);
        const auto pair = std::ranges::find(problem.limitPairs, static_cast<int>(i), &LimitPair::limited);
        if (pair == problem.limitPairs.end()) forces[n] = std::min(trial, 0.0);
        else {
            const double limit = pair->base + std::max(0.0, -pair->factor * forces[n - 1]);
            forces[n] = std::clamp(trial, -limit, limit);
        }
    }
    return forces;
}

/// Three boxes on three, half a box apart, on a fixed base.
Model wallModel(const std::vector<Bolt>& bolts = {}) {
    Scene scene = emptyScene(10e9, 0.2, 20.0);
    scene.analysis.gravity = {4.0, -9.0};
    scene.blocks = {boxBlock("base", {-1, -1}, {5, 0})};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column)
            scene.blocks.push_back(boxBlock("box", {column + 0.5 * row, row}, {column + 0.5 * row + 1.0, row + 1.0}));
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    scene.boltTypes = builtInBoltTypes();
    scene.bolts = bolts;
    return makeModel(scene);
}

void expectToFindTheStates(const Model& model) {
    for (const Inertia inertia : {Inertia::Shi, Inertia::BackwardEuler, Inertia::Newmark, Inertia::GeneralizedAlpha}) {
        StepOptions options{inertia, 1e-3};
        options.rhoInf = 0.8;
        StepProblem problem = slidingWall(model, options);
        const LinkRows rows(problem);
        StepMatrix matrix;
        matrix.begin(problem, rows);
        DualSweeps sweeps(problem, rows, DualSweeps::carriedForces(problem, rows));
        ASSERT_TRUE(sweeps.possible());
        StepWork work;
        Trial trial = trialAt(problem, rows, Eigen::VectorXd::Zero(problem.unknowns() + LinkRows::padding));
        const double before = Balance(problem, rows, trial, 0, 1e-4).residual();
        for (int round = 0; round < 3; ++round) {
            sweeps.sweep(trial, 1e-4, work);
            const auto d = sweeps.solve(trial, matrix, work);
            ASSERT_TRUE(d.has_value());
            trial = trialAt(problem, rows, *d);
        }
        EXPECT_GT(work.sweeps, 0);
        // forces settle to 3e-5 in a round
        EXPECT_LT(Balance(problem, rows, trial, 2, 1e-4).residual(), 1e-2 * before) << static_cast<int>(inertia);

        StepProblem again = slidingWall(model, options);
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        ASSERT_TRUE(StepSolver().solve(again, d, {.tolerance = 1e-9}, {}).converged) << static_cast<int>(inertia);
        EXPECT_LE((unpadded(trial.d) - d).norm(), 1e-3 * d.norm()) << static_cast<int>(inertia);
    }
}

TEST(SweptLinks, OfTwoBlocksAreVisitedTogetherWithTheResultOfOneAfterTheOther) {
    const Model model = wallModel();
    StepProblem problem = slidingWall(model, {Inertia::Shi, 1e-3});
    const LinkRows rows(problem);
    SweptLinks swept(problem, rows);
    swept.hold(padded(problem.load),
               trialAt(problem, rows, Eigen::VectorXd::Zero(problem.unknowns() + LinkRows::padding)));
    std::vector<double> forces(swept.count());
    for (std::size_t n = 0; n < forces.size(); ++n) forces[n] = -1e3 * static_cast<double>(n % 7);
    swept.clipAndPlace(forces);
    Eigen::VectorXd changes;
    for (int sweep = 0; sweep < 3; ++sweep) {
        const std::vector<double> before = forces, expected = plainSweep(problem, swept, forces);
        swept.sweep(forces, changes);
        const double largest = std::abs(std::ranges::min(expected));
        EXPECT_GT(largest, 1e3);
        for (std::size_t n = 0; n < forces.size(); ++n) {
            EXPECT_NEAR(forces[n], expected[n], 1e-9 * largest) << "link " << swept.linkOf(n) << " in sweep " << sweep;
            EXPECT_EQ(changes[static_cast<Eigen::Index>(n)], forces[n] - before[n]);
        }
    }
}

TEST(DualSweeps, FindTheStatesOfTheStep) { expectToFindTheStates(wallModel()); }

TEST(DualSweeps, FindTheStatesOfAStepWithBolts) {
    expectToFindTheStates(wallModel({rebar({0.4, 0.3}, {1.7, 0.6}), rebar({1.3, 0.5}, {2.1, 1.8})}));
}

TEST(DualSweeps, AreNotPossibleWithoutMass) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.materials[0].second.density = 0.0;
    scene.blocks = {boxBlock("box", {0, 0}, {1, 1})};
    const Model model = makeModel(scene);
    StepProblem problem = slidingWall(model, {Inertia::Shi, 1e-3});
    const LinkRows rows(problem);
    EXPECT_FALSE(DualSweeps(problem, rows, DualSweeps::carriedForces(problem, rows)).possible());
}

}  // namespace
}  // namespace keyblock
