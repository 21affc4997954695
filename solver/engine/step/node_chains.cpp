// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/node_chains.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace keyblock {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Equations of one node: its own stiffness, its coupling to the next node, and its coupling to the blocks with, in the
/// last column, its unbalanced force times −1.
struct NodeRows {
    Matrix3 own, next = Matrix3::Zero();
    Eigen::Matrix<double, 3, Eigen::Dynamic> others;
};

/// Equations of a chain with the tangents of a trial.
class ChainEquations {
public:
    ChainEquations(const StepProblem& problem, const LinkRows& rows, const Trial& trial, int firstBody,
                   const std::vector<int>& blocks)
        : problem_(problem), rows_(rows), trial_(trial), firstBody_(firstBody), blocks_(blocks),
          columns_(6 * static_cast<int>(blocks.size())), sum_(Eigen::MatrixXd::Zero(columns_, columns_ + 1)) {}

    void addNode(int body) {
        NodeRows node;
        node.own = problem_.nodeStiffness[body - problem_.blocks].asDiagonal();
        node.others.setZero(3, columns_ + 1);
        node.others.col(columns_) = -trial_.net.segment<3>(problem_.first(body));
        nodes_.push_back(std::move(node));
    }

    void addLink(std::size_t i) {
        const Link& link = problem_.links[i];
        const double* g = rows_.gradient(i);
        if (link.b < 0) addOwn(link.a, i, g);
        else if (link.a >= problem_.blocks && link.b >= problem_.blocks) addBetween(i);
        else if (link.a >= problem_.blocks) addToBlock(i, link.a, g, link.b, g + 6);
        else addToBlock(i, link.b, g + 6, link.a, g);
    }

    /// Eliminates the nodes, from the first to the last.
    CondensedChain condensed() {
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const NodeRows& node = nodes_[n];
            const Eigen::LDLT<Matrix3> factor(node.own);
            const Eigen::Matrix<double, 3, Eigen::Dynamic> solved = factor.solve(node.others);
            sum_.noalias() -= node.others.leftCols(columns_).transpose() * solved;
            if (n + 1 == nodes_.size()) break;
            nodes_[n + 1].others.noalias() -= node.next.transpose() * solved;
            nodes_[n + 1].own -= node.next.transpose() * factor.solve(node.next);
        }
        return {sum_.leftCols(columns_), -sum_.col(columns_)};
    }

private:
    double weight(std::size_t i) const { return problem_.links[i].law.share * trial_.laws[i].tangent; }
    NodeRows& node(int body) { return nodes_[body - firstBody_]; }

    void addOwn(int body, std::size_t i, const double* gradient) {
        const Eigen::Map<const Vector3> g(gradient);
        node(body).own += weight(i) * g * g.transpose();
    }

    void addBetween(std::size_t i) {
        const Link& link = problem_.links[i];
        const double* gradient = rows_.gradient(i);
        addOwn(link.a, i, gradient);
        addOwn(link.b, i, gradient + 6);
        const bool inOrder = link.a < link.b;
        const Eigen::Map<const Vector3> before(gradient + (inOrder ? 0 : 6)), after(gradient + (inOrder ? 6 : 0));
        node(std::min(link.a, link.b)).next += weight(i) * before * after.transpose();
    }

    void addToBlock(std::size_t i, int body, const double* ofNode, int block, const double* ofBlock) {
        addOwn(body, i, ofNode);
        const auto place = std::lower_bound(blocks_.begin(), blocks_.end(), block) - blocks_.begin();
        const int at = 6 * static_cast<int>(place);
        const Eigen::Map<const Vector3> g(ofNode);
        const Eigen::Map<const Vector6> h(ofBlock);
        node(body).others.middleCols<6>(at) += weight(i) * g * h.transpose();
        sum_.block<6, 6>(at, at) += weight(i) * h * h.transpose();
        sum_.col(columns_).segment<6>(at) += problem_.links[i].law.share * trial_.laws[i].force * h;
    }

    const StepProblem& problem_;
    const LinkRows& rows_;
    const Trial& trial_;
    int firstBody_;
    const std::vector<int>& blocks_;
    int columns_;  // unknowns of the blocks
    std::vector<NodeRows> nodes_;
    Eigen::MatrixXd sum_;  // stiffness between the blocks and, in the last column, the force on them times −1
};

}  // namespace

NodeChains::NodeChains(const StepProblem& problem, const LinkRows& rows) : problem_(problem), rows_(rows) {
    if (problem.nodes == 0) return;
    const auto isNode = [&](int body) { return body >= problem.blocks; };
    std::vector<char> joined(problem.nodes, 0);  // per node: linked to the one before
    for (const Link& link : problem.links) {
        if (!isNode(link.a) || !isNode(link.b)) continue;
        assert(std::abs(link.a - link.b) == 1);
        joined[std::max(link.a, link.b) - problem.blocks] = 1;
    }
    std::vector<std::size_t> chainOf;
    for (int node = 0; node < problem.nodes; ++node) {
        const int body = problem.blocks + node;
        if (!joined[node]) chains_.push_back({body, body, {}, {}});
        chains_.back().end = body + 1;
        chainOf.push_back(chains_.size() - 1);
    }
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        if (!isNode(link.a) && !isNode(link.b)) continue;
        Chain& chain = chains_[chainOf[std::max(link.a, link.b) - problem.blocks]];
        chain.links.push_back(i);
        const int other = std::min(link.a, link.b);
        if (other >= 0 && !isNode(other)) chain.blocks.push_back(other);
    }
    for (Chain& chain : chains_) {
        std::sort(chain.blocks.begin(), chain.blocks.end());
        chain.blocks.erase(std::unique(chain.blocks.begin(), chain.blocks.end()), chain.blocks.end());
    }
}

CondensedChain NodeChains::condensed(std::size_t c, const Trial& trial) const {
    const Chain& chain = chains_[c];
    ChainEquations equations(problem_, rows_, trial, chain.first, chain.blocks);
    for (int body = chain.first; body < chain.end; ++body) equations.addNode(body);
    for (const std::size_t i : chain.links) equations.addLink(i);
    return equations.condensed();
}

}  // namespace keyblock
