// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/books.h"

#include <algorithm>

namespace keyblock {
namespace {

bool known(const StepProblem& problem, Eigen::Index unknown) {
    return problem.known[static_cast<std::size_t>(unknown)] != 0;
}

bool sameLink(const Link& a, const Link& b) { return a.kind == b.kind && a.owner == b.owner && a.part == b.part; }

/// Friction limits of the links of `problem`, in their order; those of other laws as they are.
std::vector<double> limitsOf(const StepProblem& problem) {
    std::vector<double> limits;
    for (const Link& link : problem.links) limits.push_back(link.law.limit);
    return limits;
}

/// Force of a link when the search began. What multipliers carry has been found anew since; the contact remembers.
double carriedAtStart(const Link& link, double strain, const State& unaccepted) {
    if (!link.law.rigid) return carriedForce(link.law, strain);
    const Contact& c = unaccepted.contacts[static_cast<std::size_t>(link.owner)];
    return link.kind == LinkKind::Normal ? -c.normalForce : c.shearForce;
}

}  // namespace

void bookStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
              const Eigen::VectorXd& d, const StepOptions& options) {
    const SchemeFactors factors = factorsOf(options);
    // what drives a prescribed unknown works against all forces; what it gives to motion is booked with the velocities
    Eigen::VectorXd driven = netForce(problem, d) + inertiaForce(model, state, factors, d);
    if (problem.contactShare != 1.0) driven -= (problem.contactShare - 1.0) * contactForce(problem, d);
    state.energy.external += external.dot(d);
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (known(problem, i)) state.energy.external -= driven[i] * d[i];
    std::vector<double> after;
    linkStrains(problem, d, after);
    for (std::size_t i = 0; i < after.size(); ++i)
        state.energy.damped +=
            lawLoss(problem.links[i].law, problem.links[i].strain, after[i], ruleOf(problem, problem.links[i]));
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Eigen::Vector3d strain = d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
        state.energy.damped += (factors.elastic - 0.5) * model.blocks[i].area * model.thickness *
                               strain.dot(model.blocks[i].elasticity * strain);
    }
    if (options.damping != Damping{}) state.energy.damped += dampedWork(model, state, options, d);
}

StaticBooks::StaticBooks(const Model& model, const State& start, const Loads& loads, const LoadPoint& before)
    : model_(model), loads_(loads), before_(before), start_(start) {
    StepProblem problem = buildStep(model, start, loads, before, {Inertia::None});
    first_ = forcesOf(problem, start, before);
}

StaticBooks::Forces StaticBooks::forcesOf(StepProblem& problem, const State& state, const LoadPoint& at) const {
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
    correctFrictionLimits(problem, still);
    double total = 0.0;
    return {externalForce(model_, state, loads_, at, total), netForce(problem, still)};
}

/// The links of the end as they were at the start.
StepProblem StaticBooks::atStart(const State& end) const {
    State start = start_;
    start.contacts = end.contacts;
    StepProblem problem = buildStep(model_, start, loads_, before_, {Inertia::None});
    correctFrictionLimits(problem, Eigen::VectorXd::Zero(problem.unknowns()));
    return problem;
}

void StaticBooks::book(State& end, const LoadPoint& at, const Eigen::VectorXd& moved, StepProblem& problem) const {
    const Forces last = forcesOf(problem, end, at);
    for (Eigen::Index i = 0; i < moved.size(); ++i) {
        end.energy.external += 0.5 * (first_.external[i] + last.external[i]) * moved[i];
        if (known(problem, i)) end.energy.external -= 0.5 * (first_.net[i] + last.net[i]) * moved[i];
        else end.energy.damped += 0.5 * (first_.net[i] + last.net[i]) * moved[i];
    }
    const StepProblem start = atStart(end);
    const std::vector<double> startLimits = limitsOf(start);
    problem.slipForce.assign(problem.links.size(), 0.0);
    std::size_t s = 0;
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.kind == LinkKind::Chord) continue;
        while (!sameLink(start.links.at(s), link)) ++s;  // the same links but for chords, in the same order
        const double carried = carriedAtStart(link, start.links[s].strain, end);
        const PathWork path = pathWork(link.law, {start.links[s].strain, carried, startLimits[s]}, link.strain);
        ++s;
        problem.slipForce[i] = path.slipForce;
        // forces that rise late let the loads run on; forces that rise early ask more of them
        if (path.surplus > 0.0) end.energy.damped += path.surplus;
        else end.energy.external -= path.surplus;
    }
}

}  // namespace keyblock
