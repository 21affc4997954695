// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/carrier/carrier.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr double stuckShare = 1e-12;  // of the limit: allows for round-off of a force that reaches it

}  // namespace

bool reachesLimit(const Law& law, double force) { return !(std::abs(force) < law.limit * (1.0 - stuckShare)); }

StepProblem stepForLinks(const Model& model) {
    StepProblem problem;
    problem.blocks = static_cast<int>(model.blocks.size());
    problem.nodes = model.nodes;
    return problem;
}

double addLinkEnergy(const StepProblem& problem, double sum) {
    for (const Link& link : problem.links)
        sum += link.law.share * storedEnergy(link.law, respond(link.law, link.strain).force);
    return sum;
}

}  // namespace keyblock
