// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/trial.h"

#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/parallel.h"

#include <utility>

namespace keyblock {
namespace {

constexpr std::size_t lawsATask = 4096;

/// Sets the net forces to the loads minus the forces of the bodies' own stiffness.
void takeBodies(const StepProblem& problem, Trial& trial) {
    trial.net.resize(trial.d.size());
    trial.net.tail<LinkRows::padding>().setZero();
    for (int i = 0; i < problem.blocks; ++i) {
        const Vector6 own = problem.blockStiffness[i] * trial.d.segment<6>(6 * i);
        trial.net.segment<6>(6 * i) = problem.load.segment<6>(6 * i) - own;
    }
    for (int i = 0; i < problem.nodes; ++i) {
        const int at = problem.first(problem.blocks + i);
        const Eigen::Vector3d own = problem.nodeStiffness[i].cwiseProduct(trial.d.segment<3>(at));
        trial.net.segment<3>(at) = problem.load.segment<3>(at) - own;
    }
}

/// Evaluates the laws at the current strains, and sets the friction limits to match.
void evaluateLaws(StepProblem& problem, const LinkRows& rows, Trial& trial) {
    trial.laws.resize(rows.count());
    const auto respondAt = [&](std::size_t i) { trial.laws[i] = respond(problem, problem.links[i], trial.strains[i]); };
    forEach(rows.count(), lawsATask, [&](std::size_t i) {
        const FlatLaw& law = rows.law(i);
        if (isBentAt(law, trial.strains[i])) return respondAt(i);
        double low = law.bounds.low, high = law.bounds.high;
        if (law.bounds.follows) {
            high = problem.links[i].law.limit = law.bounds.limit(forceOf(rows.law(i - 1), trial.strains[i - 1]));
            low = -high;
        }
        trial.laws[i] = respond(law, trial.strains[i], low, high);
    });
    for (const LimitPair& pair : problem.limitPairs) {
        if (!rows.law(pair.limited).bounds.bent) continue;
        setLimit(problem, pair, trial.laws[pair.from].force);
        respondAt(static_cast<std::size_t>(pair.limited));
    }
}

void judge(StepProblem& problem, const LinkRows& rows, Trial& trial) {
    evaluateLaws(problem, rows, trial);
    takeBodies(problem, trial);
    for (std::size_t i = 0; i < rows.count(); ++i)
        if (const double force = rows.law(i).share * trial.laws[i].force; force != 0.0)
            rows.add(i, -force, trial.net.data());
}

}  // namespace

Trial trialAt(StepProblem& problem, const LinkRows& rows, Eigen::VectorXd d) {
    Trial trial;
    trial.d = std::move(d);
    rows.strains(trial.d, trial.strains);
    judge(problem, rows, trial);
    return trial;
}

void advance(StepProblem& problem, const LinkRows& rows, const Trial& from, const Eigen::VectorXd& direction,
             const std::vector<double>& rates, double length, Trial& to) {
    to.d = from.d + length * direction;
    to.strains.resize(rates.size());
    for (std::size_t i = 0; i < rates.size(); ++i) to.strains[i] = from.strains[i] + length * rates[i];
    judge(problem, rows, to);
}

Eigen::VectorXd bodyProduct(const StepProblem& problem, const Eigen::VectorXd& x) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
    for (int i = 0; i < problem.blocks; ++i)
        force.segment<6>(6 * i).noalias() = problem.blockStiffness[i] * x.segment<6>(6 * i);
    for (int i = 0; i < problem.nodes; ++i) {
        const int at = problem.first(problem.blocks + i);
        force.segment<3>(at) = problem.nodeStiffness[i].cwiseProduct(x.segment<3>(at));
    }
    return force;
}

}  // namespace keyblock
