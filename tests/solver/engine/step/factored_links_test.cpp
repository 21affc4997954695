// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The factor of one step serves the next: links are found again whatever their order,
// those that end or turn are replaced, and what the factor does not know any more is
// corrected to round-off.
#include "solver/engine/step/coupled_friction.h"
#include "solver/engine/step/factored_links.h"
#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/trial.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace keyblock {
namespace {

constexpr int bodies = 4;

/// A contact between two neighbours in a row of bodies; its direction is turned by `angle` [rad].
Link between(int a, int corner, double angle) {
    Link link;
    link.kind = LinkKind::Normal;
    link.a = a;
    link.b = a + 1;
    link.features = static_cast<std::uint64_t>(corner);
    const double c = std::cos(angle), s = std::sin(angle);
    link.ga << c, s, 0.3 * corner, 0.1, 0.0, 0.0;
    link.gb = -link.ga;
    link.law = {LawKind::Linear, 1e6 * (1.0 + corner), 0.0, 0.0, nullptr, {}, 1.0, false};
    return link;
}

StepProblem rowOfBodies(std::vector<Link> links) {
    StepProblem problem;
    problem.blocks = bodies;
    problem.blockStiffness.assign(bodies, 1e3 * Matrix6::Identity());
    problem.links = std::move(links);
    problem.known.assign(6 * bodies, 0);
    problem.value = Eigen::VectorXd::Zero(6 * bodies);
    problem.weight = Eigen::VectorXd::Ones(6 * bodies);
    problem.load = Eigen::VectorXd::LinSpaced(6 * bodies, 1.0, 2.0);
    problem.moves = true;
    problem.ownForce.assign(bodies, 1.0);
    return problem;
}

std::vector<Link> links(double angle) {
    std::vector<Link> all;
    for (int a = 0; a + 1 < bodies; ++a)
        for (int corner = 1; corner <= 2; ++corner) all.push_back(between(a, corner, angle));
    return all;
}

std::vector<double> weightsOf(const StepProblem& problem) {
    std::vector<double> weights;
    for (const Link& link : problem.links) weights.push_back(link.law.stiffness);
    return weights;
}

Eigen::VectorXd exactly(const StepProblem& problem) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(6 * bodies, 6 * bodies) * 1e3;
    for (const Link& link : problem.links) {
        Eigen::VectorXd g = Eigen::VectorXd::Zero(6 * bodies);
        g.segment<6>(6 * link.a) = link.ga;
        g.segment<6>(6 * link.b) = link.gb;
        matrix += link.law.stiffness * g * g.transpose();
    }
    return matrix.ldlt().solve(problem.load);
}

TEST(FactoredLinks, AreFoundAgainInAnotherOrder) {
    FactoredLinks factored;
    const StepProblem first = rowOfBodies(links(0.0));
    const LinkRows rows(first);
    EXPECT_FALSE(factored.begin(first, rows));
    factored.renew(rows, weightsOf(first));
    std::vector<Link> turnedRound = links(0.0);
    std::reverse(turnedRound.begin(), turnedRound.end());
    const StepProblem second = rowOfBodies(turnedRound);
    const LinkRows after(second);
    EXPECT_FALSE(factored.begin(second, after));
    EXPECT_EQ(factored.changesTo(after, weightsOf(second)).count(), 0u);
    EXPECT_TRUE(factored.begin(second, after));
}

TEST(FactoredLinks, EndAppearAndTurnOneByOne) {
    FactoredLinks factored;
    const StepProblem first = rowOfBodies(links(0.0));
    const LinkRows rows(first);
    factored.begin(first, rows);
    factored.renew(rows, weightsOf(first));
    std::vector<Link> later = links(0.0);
    later[0] = between(0, 7, 0.0);  // one ends, another appears
    later[3] = between(1, 2, 0.1);  // one has turned far: it is taken out and put in
    later[4] = between(2, 1, 1e-3);  // one has turned next to nothing
    const StepProblem second = rowOfBodies(later);
    const LinkRows after(second);
    factored.begin(second, after);
    const FactoredLinks::Changes changes = factored.changesTo(after, weightsOf(second));
    EXPECT_EQ(changes.add.size(), 2u);
    EXPECT_EQ(changes.take.size(), 2u);
    factored.change(after, weightsOf(second));
    EXPECT_EQ(factored.changesTo(after, weightsOf(second)).count(), 0u);
}

TEST(StepMatrix, KeptFromAnEarlierStepSolvesToRoundOff) {
    StepMatrix matrix;
    StepWork work;
    for (const double angle : {0.0, 2e-3, 4e-3, 6e-3}) {
        StepProblem problem = rowOfBodies(links(angle));
        const LinkRows rows(problem);
        matrix.begin(problem, rows);
        ASSERT_LT(matrix.factor(problem, rows, weightsOf(problem), work), 0);
        EXPECT_EQ(matrix.exact(), angle == 0.0);
        const Trial start = trialAt(problem, rows, padded(Eigen::VectorXd::Zero(6 * bodies)));
        const Direction direction = coupledDirection(problem, rows, start, matrix, 1.0, false, work);
        const Eigen::VectorXd exact = exactly(problem);
        EXPECT_LE((unpadded(direction.displacement) - exact).norm(), 1e-6 * exact.norm()) << angle;
    }
    EXPECT_EQ(work.factorizations, 1);
}

// Round-off times the condition number: the links are 4e6 times as stiff as a node alone, and blocks multiply it by 10
constexpr double solvedTo = 1e-8;

/// A row of bodies, each with a bolt node that a spring connects to it.
StepProblem rowOfBodiesWithNodes() {
    StepProblem problem = rowOfBodies(links(0.0));
    problem.nodes = bodies;
    problem.nodeStiffness.assign(bodies, Eigen::Vector3d::Ones());
    problem.known.assign(problem.unknowns(), 0);
    problem.value = Eigen::VectorXd::Zero(problem.unknowns());
    problem.weight = Eigen::VectorXd::Ones(problem.unknowns());
    problem.load = Eigen::VectorXd::LinSpaced(problem.unknowns(), 1.0, 2.0);
    problem.ownForce.assign(2 * bodies, 1.0);
    for (int node = 0; node < bodies; ++node) {
        Link link = between(node, 3, 0.3 * node);
        link.kind = LinkKind::AnchorSlip;
        link.owner = node;
        link.b = bodies + node;
        link.gb << -link.ga.head<3>(), 0.0, 0.0, 0.0;
        problem.links.push_back(link);
    }
    return problem;
}

/// The nodes of a lost bolt are prescribed, and no link acts on them; their weight remains in the loads. With
/// `keepsLinks`, the links of the node remain.
StepProblem withoutNode(StepProblem problem, int node, bool keepsLinks) {
    for (int k = 0; k < 3; ++k) problem.known[problem.first(bodies + node) + k] = 1;
    problem.load.segment<3>(problem.first(bodies + node)) *= 1e6;
    if (!keepsLinks) std::erase_if(problem.links, [&](const Link& link) { return link.b == bodies + node; });
    return problem;
}

Eigen::VectorXd solved(StepMatrix& matrix, const StepProblem& problem, StepWork& work) {
    const LinkRows rows(problem);
    matrix.begin(problem, rows);
    EXPECT_LT(matrix.factor(problem, rows, weightsOf(problem), work), 0);
    return unpadded(matrix.solve(padded(problem.load), work));
}

TEST(StepMatrix, KeepsItsFactorWhenABoltIsLost) {
    StepMatrix kept;
    StepWork work;
    StepProblem problem = rowOfBodiesWithNodes();
    solved(kept, problem, work);
    problem = withoutNode(problem, 2, false);
    const Eigen::VectorXd d = solved(kept, problem, work);
    EXPECT_EQ(work.fullFactorizations, 1);
    StepMatrix fresh;
    EXPECT_LE((d - solved(fresh, problem, work)).norm(), solvedTo * d.norm());
    EXPECT_TRUE(d.segment<3>(problem.first(bodies + 2)).isZero(0.0));
    kept.forget();  // the pattern is kept when the factor is made again
    EXPECT_LE((solved(kept, problem, work) - d).norm(), solvedTo * d.norm());
    problem = rowOfBodiesWithNodes();  // the step in which the bolt was lost is repeated
    StepMatrix whole;
    const Eigen::VectorXd before = solved(whole, problem, work);
    EXPECT_LE((solved(kept, problem, work) - before).norm(), solvedTo * before.norm());
}

TEST(StepMatrix, BeginsAgainWhenManyBoltsAreLostOrANodeThatStillActsIsPrescribed) {
    const auto factorsAfter = [](const StepProblem& later) {
        StepMatrix matrix;
        StepWork work;
        solved(matrix, rowOfBodiesWithNodes(), work);
        const Eigen::VectorXd d = solved(matrix, later, work);
        StepMatrix fresh;
        StepWork own;
        EXPECT_LE((d - solved(fresh, later, own)).norm(), solvedTo * d.norm());
        return work.fullFactorizations;
    };
    const StepProblem all = rowOfBodiesWithNodes();
    EXPECT_EQ(factorsAfter(withoutNode(all, 1, false)), 1);
    EXPECT_EQ(factorsAfter(withoutNode(all, 1, true)), 2);
    EXPECT_EQ(factorsAfter(withoutNode(withoutNode(all, 1, false), 2, false)), 2);
    StepProblem massless = withoutNode(all, 1, false);
    massless.nodeStiffness[1].setZero();
    EXPECT_EQ(factorsAfter(massless), 2);
}

TEST(StepMatrix, KeptFactorFollowsAWeightThatChanges) {
    StepMatrix matrix;
    StepWork work;
    StepProblem problem = rowOfBodies(links(0.0));
    const LinkRows rows(problem);
    matrix.begin(problem, rows);
    ASSERT_LT(matrix.factor(problem, rows, weightsOf(problem), work), 0);
    problem.links[2].law.stiffness *= 3.0;
    matrix.begin(problem, rows);
    ASSERT_LT(matrix.factor(problem, rows, weightsOf(problem), work), 0);
    const Trial start = trialAt(problem, rows, padded(Eigen::VectorXd::Zero(6 * bodies)));
    const Direction direction = coupledDirection(problem, rows, start, matrix, 1.0, false, work);
    const Eigen::VectorXd exact = exactly(problem);
    EXPECT_LE((unpadded(direction.displacement) - exact).norm(), 1e-6 * exact.norm());
}

}  // namespace
}  // namespace keyblock
