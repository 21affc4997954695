// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solving for a few bodies alone: their forces are those of the whole step, and a step
// with loose blocks among others at rest ends in balance.
#include "solver/engine/step/local_step.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/step/step_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace keyblock {
namespace {

/// Blocks and bolt nodes with springs between all of them, and to the ground, with random gradients.
StepProblem randomStep(int blocks, int nodes) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto vector = [&](int size) {
        return Eigen::VectorXd(Eigen::VectorXd::NullaryExpr(size, [&] { return number(random); }));
    };
    StepProblem step;
    step.blocks = blocks, step.nodes = nodes;
    const int n = step.unknowns();
    step.load = vector(n);
    step.known.assign(n, 0);
    step.known[6] = 1;
    step.value = Eigen::VectorXd::Zero(n);
    step.value[6] = 0.3;
    step.weight = Eigen::VectorXd::Ones(n);
    for (int i = 0; i < blocks; ++i) step.blockStiffness.push_back((2.0 + i) * Matrix6::Identity());
    for (int i = 0; i < nodes; ++i) step.nodeStiffness.push_back((1.0 + i) * Eigen::Vector3d::Ones());
    step.ownForce.assign(blocks + nodes, 1.0);
    step.mayLeave.assign(blocks + nodes, 1e-9);
    const auto link = [&](int a, int b, LawKind law) {
        Link& added = step.links.emplace_back();
        added.kind = LinkKind::Support;
        added.a = a, added.b = b;
        added.strain = number(random), added.shift = 0.1 * number(random);
        added.law.kind = law, added.law.stiffness = 5.0, added.law.limit = 0.5;
        added.ga.head(step.width(a)) = vector(step.width(a));
        if (b >= 0) added.gb.head(step.width(b)) = vector(step.width(b));
    };
    for (int a = 0; a < blocks + nodes; ++a)
        for (int b = -1; b < a; ++b) {
            link(a, b, LawKind::Gap);
            link(a, b, LawKind::Capped);
            const int last = static_cast<int>(step.links.size()) - 1;
            step.limitPairs.push_back({last, last - 1, 0.6});
        }
    return step;
}

TEST(LocalStep, ForcesAreThoseOfTheWholeStep) {
    StepProblem whole = randomStep(4, 3);
    const Eigen::VectorXd d = Eigen::VectorXd::LinSpaced(whole.unknowns(), -0.4, 0.6);
    const Eigen::VectorXd net = netForce(whole, d);
    LocalStep local = localStep(whole, LinkRows(whole), {1, 2, 5}, d);
    ASSERT_EQ(local.problem.unknowns(), 6 + 6 + 3);
    const Eigen::VectorXd own = local.taken(whole, d);
    const Eigen::VectorXd ownNet = netForce(local.problem, own);
    EXPECT_LE((ownNet - local.taken(whole, net)).norm(), 1e-13 * net.norm());
    EXPECT_EQ(local.problem.known, (std::vector<char>{1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
    Eigen::VectorXd again = Eigen::VectorXd::Zero(whole.unknowns());
    local.insert(whole, own, again);
    EXPECT_EQ(again.segment(6, 12), d.segment(6, 12));
    EXPECT_EQ(again.segment(whole.first(5), 3), d.segment(whole.first(5), 3));
    EXPECT_EQ(again.head(6), Eigen::VectorXd::Zero(6));
}

TEST(LocalStep, FrictionFollowsTheNormalForcesThatRemain) {
    const StepProblem whole = randomStep(3, 1);
    const LocalStep local = localStep(whole, LinkRows(whole), {0}, Eigen::VectorXd::Zero(whole.unknowns()));
    // every other body is linked with the first one by two links and one pair, which keep their order
    ASSERT_EQ(local.problem.links.size(), 2u * 4);
    ASSERT_EQ(local.problem.limitPairs.size(), 4u);
    for (std::size_t i = 0; i < local.problem.limitPairs.size(); ++i) {
        EXPECT_EQ(local.problem.limitPairs[i].from, static_cast<int>(2 * i));
        EXPECT_EQ(local.problem.limitPairs[i].limited, static_cast<int>(2 * i) + 1);
        EXPECT_EQ(local.problem.links[2 * i].a, 0);
        EXPECT_EQ(local.problem.links[2 * i].b, -1);
    }
}

/// A row of blocks, each linked to the next, of which the last but one is fixed.
TEST(LocalStep, NeighboursAreFoundRingByRing) {
    StepProblem row;
    row.blocks = 6;
    row.known.assign(row.unknowns(), 0);
    std::fill(row.known.begin() + row.first(4), row.known.begin() + row.first(5), 1);
    row.weight = Eigen::VectorXd::Ones(row.unknowns());
    for (int i = 0; i < 5; ++i) {
        Link& link = row.links.emplace_back();
        link.a = i, link.b = i + 1;
        link.ga[0] = -1.0, link.gb[0] = 1.0;
    }
    const LinkRows rows(row);
    EXPECT_EQ(withNeighbours(row, rows, {1}, 0), (std::vector<int>{1}));
    EXPECT_EQ(withNeighbours(row, rows, {0}, 2), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(withNeighbours(row, rows, {0, 3}, 3), (std::vector<int>{0, 1, 2, 3}));
    EXPECT_EQ(withNeighbours(row, rows, {5}, 2), (std::vector<int>{5}));
    EXPECT_TRUE(withNeighbours(row, rows, {}, 2).empty());
}

/// Blocks at rest on springs, and loose blocks that are pushed towards stops at very different distances; only their
/// inertia, a ten-millionth of the stops, holds them.
TEST(LocalStep, LooseBlocksComeToRestAgainstTheirStops) {
    constexpr int resting = 150, loose = 10;
    constexpr double inertia = 1e-4, stop = 1e3, push = 1e-2;
    const auto distance = [](int i) { return std::pow(4.0, -i); };
    StepProblem step;
    step.blocks = resting + loose;
    const int n = step.unknowns();
    step.load = Eigen::VectorXd::Zero(n);
    step.known.assign(n, 0);
    step.value = Eigen::VectorXd::Zero(n);
    step.weight = Eigen::VectorXd::Ones(n);
    step.ownForce.assign(step.blocks, push);
    step.mayLeave.assign(step.blocks, 1e-6 * push);
    step.blockStiffness.assign(step.blocks, inertia * Matrix6::Identity());
    const auto link = [&](int a, int b, LawKind kind, double sign, double offset) {
        Link& added = step.links.emplace_back();
        added.a = a, added.b = b;
        added.ga[0] = sign;
        if (b >= 0) added.gb[0] = -sign;
        added.law.kind = kind, added.law.stiffness = stop, added.law.offset = offset;
    };
    for (int i = 0; i < resting; ++i) link(i, i - 1, LawKind::Linear, 1.0, 0.0);
    for (int i = 0; i < loose; ++i) {
        step.load[6 * (resting + i)] = push;
        link(resting + i, i, LawKind::Gap, -1.0, -distance(i));
    }
    Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
    const SolveReport report = StepSolver().solve(step, d, {.tolerance = 1e-9}, {});
    ASSERT_TRUE(report.converged);
    for (int i = 0; i < loose; ++i) {
        // its stop is carried by i + 1 springs in a row, of which the loose blocks before it take their share
        const double at = d[6 * (resting + i)], past = at - d[6 * i] - distance(i);
        EXPECT_NEAR(inertia * at + stop * std::max(0.0, past), push, 1e-6 * push) << i;
        EXPECT_GT(past, 0.0) << i;
    }
}

}  // namespace
}  // namespace keyblock
