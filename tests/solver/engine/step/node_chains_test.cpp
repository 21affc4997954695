// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts condensed onto their blocks: the force on the blocks is the one that a dense
// solution of all bolt nodes gives, at rest and where the blocks have moved on.
#include "solver/engine/step/node_chains.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/verify/scenes.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace keyblock {
namespace {

Bolt rebar(const char* name, Point farEnd, Point head) {
    Bolt bolt;
    bolt.name = name;
    bolt.type = "rebar-20";
    bolt.farEnd = farEnd;
    bolt.head = head;
    bolt.divisions = 12;
    return bolt;
}

/// Three boxes side by side; one bolt crosses them all, another one only the last joint.
Model boltedModel() {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("left", {0, 0}, {1, 1}), boxBlock("middle", {1, 0}, {2, 1}),
                    boxBlock("right", {2, 0}, {3, 1})};
    scene.boltTypes = builtInBoltTypes();
    scene.bolts = {rebar("long", {0.2, 0.3}, {2.9, 0.4}), rebar("short", {1.6, 0.7}, {2.8, 0.9})};
    return makeModel(scene);
}

/// A step in which the blocks have moved by different amounts while the bolts have not.
struct BoltedStep {
    BoltedStep() : state(makeState(model)) {
        placeBolts(model, state);
        LoadPoint at;
        at.gravity = 1.0;
        problem = buildStep(model, state, Loads{}, at, {Inertia::Shi, 1e-3});
        rows.emplace(problem);
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns() + LinkRows::padding);
        for (int i = 0; i < 6 * problem.blocks; ++i) d[i] = 1e-5 * std::sin(1.0 + i);
        trial = trialAt(problem, *rows, d);
    }

    Model model = boltedModel();
    State state;
    StepProblem problem;
    std::optional<LinkRows> rows;
    Trial trial;
};

/// Tangent stiffness of the links of bolt nodes, and of the nodes themselves, over all unknowns.
Eigen::MatrixXd nodeStiffness(const BoltedStep& step) {
    const int unknowns = step.problem.unknowns();
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (int n = 0; n < step.problem.nodes; ++n)
        sum.diagonal().segment<3>(step.problem.first(step.problem.blocks + n)) += step.problem.nodeStiffness[n];
    for (std::size_t i = 0; i < step.rows->count(); ++i) {
        const Link& link = step.problem.links[i];
        if (std::max(link.a, link.b) < step.problem.blocks) continue;
        Eigen::VectorXd g = Eigen::VectorXd::Zero(unknowns + LinkRows::padding);
        step.rows->add(i, 1.0, g.data());
        sum += link.law.share * step.trial.laws[i].tangent * unpadded(g) * unpadded(g).transpose();
    }
    return sum;
}

/// Force of the bolts on the blocks when the blocks have moved on by `v` and the nodes are in equilibrium.
Eigen::VectorXd denseForce(const BoltedStep& step, const Eigen::VectorXd& v) {
    const int blocks = 6 * step.problem.blocks, nodes = 3 * step.problem.nodes;
    const Eigen::MatrixXd stiffness = nodeStiffness(step);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(step.problem.unknowns() + LinkRows::padding);
    for (std::size_t i = 0; i < step.rows->count(); ++i)
        if (const Link& link = step.problem.links[i]; std::max(link.a, link.b) >= step.problem.blocks)
            step.rows->add(i, -link.law.share * step.trial.laws[i].force, force.data());
    const Eigen::VectorXd net = step.trial.net.segment(blocks, nodes);
    const Eigen::MatrixXd own = stiffness.bottomRightCorner(nodes, nodes),
                          coupling = stiffness.bottomLeftCorner(nodes, blocks);
    const Eigen::VectorXd u = own.partialPivLu().solve(net - coupling * v);
    return force.head(blocks) - stiffness.topLeftCorner(blocks, blocks) * v - coupling.transpose() * u;
}

TEST(NodeChains, AreTheBolts) {
    const BoltedStep step;
    const NodeChains chains(step.problem, *step.rows);
    ASSERT_EQ(chains.count(), 2u);
    EXPECT_EQ(chains.blocks(0), (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(chains.blocks(1), (std::vector<int>{1, 2}));
}

TEST(NodeChains, ActOnTheBlocksAsAllNodesSolvedTogether) {
    const BoltedStep step;
    const NodeChains chains(step.problem, *step.rows);
    for (const double moved : {0.0, 1e-5}) {
        Eigen::VectorXd v(6 * step.problem.blocks);
        for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = moved * std::cos(static_cast<double>(i));
        Eigen::VectorXd sum = Eigen::VectorXd::Zero(v.size());
        for (std::size_t c = 0; c < chains.count(); ++c) {
            const CondensedChain chain = chains.condensed(c, step.trial);
            const std::vector<int>& blocks = chains.blocks(c);
            Eigen::VectorXd ofChain(chain.force.size());
            for (std::size_t k = 0; k < blocks.size(); ++k) ofChain.segment<6>(6 * k) = v.segment<6>(6 * blocks[k]);
            const Eigen::VectorXd force = chain.force - chain.stiffness * ofChain;
            for (std::size_t k = 0; k < blocks.size(); ++k) sum.segment<6>(6 * blocks[k]) += force.segment<6>(6 * k);
        }
        const Eigen::VectorXd expected = denseForce(step, v);
        ASSERT_GT(expected.norm(), 1.0);
        EXPECT_LE((sum - expected).norm(), 1e-9 * expected.norm());
    }
}

}  // namespace
}  // namespace keyblock
