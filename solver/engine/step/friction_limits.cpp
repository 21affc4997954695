// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/friction_limits.h"

#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

double limitFrom(const LimitPair& pair, double force) {
    const double part = pair.factor * force;
    switch (pair.rule) {
        case LimitPair::Rule::Push: return pair.base + std::max(0.0, -part);
        case LimitPair::Rule::Clamp: return pair.base + std::abs(part);
    }
    return pair.base;
}

}  // namespace

void setLimit(StepProblem& problem, const LimitPair& pair, double force) {
    Law& limited = problem.links[pair.limited].law;
    // a constant force kept during the preload search does not depend on other forces
    if (limited.kind == LawKind::Constant && pair.rule != LimitPair::Rule::Push) return;
    const bool weighted = ofContact(problem.links[pair.from].kind);
    limited.limit = limitFrom(pair, weighted ? force / problem.contactShare : force);
}

void correctFrictionLimits(StepProblem& problem, const Eigen::VectorXd& d) {
    if (problem.limitPairs.empty()) return;
    // with mean forces over the step, friction is limited by the mean normal force, so that impulses obey Coulomb's law
    for (const LimitPair& pair : problem.limitPairs) {
        const Link& from = problem.links[pair.from];
        setLimit(problem, pair, respond(problem, from, linkStrain(problem, from, d)).force);
    }
}

}  // namespace keyblock
