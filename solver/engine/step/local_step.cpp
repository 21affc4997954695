// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/local_step.h"

#include <utility>

namespace keyblock {
namespace {

/// Adds a body to `part`, whose vectors have their final length.
void addBody(const StepProblem& whole, int body, StepProblem& part) {
    const bool block = body < whole.blocks;
    const int first = whole.first(body), width = whole.width(body);
    const Eigen::Index at = part.unknowns();
    if (block) part.blockStiffness.push_back(whole.blockStiffness[body]);
    else part.nodeStiffness.push_back(whole.nodeStiffness[body - whole.blocks]);
    ++(block ? part.blocks : part.nodes);
    part.load.segment(at, width) = whole.load.segment(first, width);
    part.value.segment(at, width) = whole.value.segment(first, width);
    part.weight.segment(at, width) = whole.weight.segment(first, width);
    part.known.insert(part.known.end(), whole.known.begin() + first, whole.known.begin() + first + width);
    part.ownForce.push_back(whole.ownForce[body]);
    if (!whole.mayLeave.empty()) part.mayLeave.push_back(whole.mayLeave[body]);
}

/// A link of the whole step in the numbering of the part. The displacement of a body outside the part becomes a
/// constant part of the strain.
Link linkOf(const StepProblem& whole, const std::vector<int>& rowOf, const Link& link, const Eigen::VectorXd& d) {
    Link own = link;
    const auto hold = [&](int body, const Vector6& gradient) {
        const int width = whole.width(body);
        own.shift += gradient.head(width).dot(d.segment(whole.first(body), width));
    };
    own.a = rowOf[link.a];
    own.b = link.b < 0 ? -1 : rowOf[link.b];
    if (link.b >= 0 && own.b < 0) {
        hold(link.b, link.gb);
        own.gb.setZero();
    } else if (own.a < 0) {
        hold(link.a, link.ga);
        own.a = std::exchange(own.b, -1);
        own.ga = std::exchange(own.gb, Vector6::Zero());
    }
    return own;
}

}  // namespace

Eigen::VectorXd LocalStep::taken(const StepProblem& whole, const Eigen::VectorXd& d) const {
    Eigen::VectorXd own(problem.unknowns());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int row = static_cast<int>(i), width = problem.width(row);
        own.segment(problem.first(row), width) = d.segment(whole.first(bodies[i]), width);
    }
    return own;
}

void LocalStep::insert(const StepProblem& whole, const Eigen::VectorXd& own, Eigen::VectorXd& d) const {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const int row = static_cast<int>(i), width = problem.width(row);
        d.segment(whole.first(bodies[i]), width) = own.segment(problem.first(row), width);
    }
}

std::vector<int> withNeighbours(const StepProblem& whole, const LinkRows& rows, const std::vector<int>& bodies,
                                int rings) {
    std::vector<char> near(whole.blocks + whole.nodes, 0);
    for (const int body : bodies) near[body] = 1;
    for (int ring = 0; ring < rings; ++ring) {
        const std::vector<char> before = near;
        for (std::size_t i = 0; i < rows.count(); ++i) {
            const int a = rows.bodyA(i), b = rows.bodyB(i);
            if (b < 0 || before[a] == before[b]) continue;
            if (!isDriven(whole, before[a] ? a : b)) near[a] = near[b] = 1;
        }
    }
    std::vector<int> all;
    for (int body = 0; body < whole.blocks + whole.nodes; ++body)
        if (near[body] && !isDriven(whole, body)) all.push_back(body);
    return all;
}

LocalStep localStep(const StepProblem& whole, const LinkRows& rows, std::vector<int> bodies, const Eigen::VectorXd& d) {
    LocalStep local;
    StepProblem& part = local.problem;
    std::vector<int> rowOf(whole.blocks + whole.nodes, -1), linkRow(whole.links.size(), -1);
    Eigen::Index unknowns = 0;
    for (const int body : bodies) unknowns += whole.width(body);
    for (Eigen::VectorXd* values : {&part.load, &part.value, &part.weight}) values->resize(unknowns);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        rowOf[bodies[i]] = static_cast<int>(i);
        addBody(whole, bodies[i], part);
    }
    for (std::size_t i = 0; i < whole.links.size(); ++i) {
        const int a = rows.bodyA(i), b = rows.bodyB(i);
        if (rowOf[a] < 0 && (b < 0 || rowOf[b] < 0)) continue;
        linkRow[i] = static_cast<int>(part.links.size());
        part.links.push_back(linkOf(whole, rowOf, whole.links[i], d));
    }
    for (LimitPair pair : whole.limitPairs) {
        pair.limited = linkRow[pair.limited];
        pair.from = linkRow[pair.from];
        if (pair.limited >= 0 && pair.from >= 0) part.limitPairs.push_back(pair);
    }
    part.rule = whole.rule;
    part.contactShare = whole.contactShare;
    part.floorForce = whole.floorForce;
    part.moves = whole.moves;
    local.bodies = std::move(bodies);
    return local;
}

}  // namespace keyblock
