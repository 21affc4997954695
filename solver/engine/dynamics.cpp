// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/dynamics.h"

#include "solver/engine/bolt_topology.h"
#include "solver/engine/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double shortestStep = 1e-6;  // over the given step: shorter is a failure
constexpr double eventStep = 1e-3;  // over the given step: shorter steps take the event as it comes
constexpr double locateShare = 1e-4;
constexpr double nearShare = 1e-3;  // of the smallest block: contacts are always sought this far
constexpr double preloadInertia = 1e-7;  // over the contact springs, while preload is sought
constexpr int preloadRounds = 4;

/// New velocity of every body, and the kinetic energy that backward Euler loses beyond its forces' work.
void moveOn(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d, Inertia scheme,
            double dt) {
    const auto next = [&](auto& velocity, const auto& displacement, const auto& energyOf) {
        const auto before = velocity;
        if (scheme == Inertia::Shi) {
            velocity = 2.0 / dt * displacement - before;
        } else {
            velocity = displacement / dt;
            state.energy.damped += energyOf(velocity - before);
        }
    };
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Vector6 own = d.segment<6>(6 * static_cast<Eigen::Index>(i));
        next(state.blocks[i].velocity, own,
             [&](const Vector6& dv) { return 0.5 * dv.dot(model.blocks[i].massMatrix * dv); });
    }
    const double factor = scheme == Inertia::Shi ? 0.5 * dt * dt : dt * dt;
    int node = 0;
    for (BoltMotion& bolt : state.bolts)
        for (BoltNode& n : bolt.nodes) {
            const Eigen::Vector3d own = d.segment<3>(problem.first(problem.blocks + node));
            const Eigen::Vector3d mass = factor * problem.nodeStiffness[static_cast<std::size_t>(node)];
            next(n.velocity, own,
                 [&](const Eigen::Vector3d& dv) { return 0.5 * dv.dot(mass.cwiseProduct(dv)); });
            ++node;
        }
}

/// What one law lost to the scheme: work of its force at the end, less what it stored and used (theory, "Energies").
double lawLoss(const Law& law, double before, double after) {
    // a friction limit may have fallen since: before the step the law carried what its offset says
    const double f0 = law.kind == LawKind::Capped ? law.stiffness * (before - law.offset) : respond(law, before).force;
    const double f1 = respond(law, after).force;
    double used = 0.0;
    if (law.kind == LawKind::Capped && law.stiffness > 0.0)
        used = f1 * ((after - f1 / law.stiffness) - (before - f0 / law.stiffness));
    if (law.kind == LawKind::Curve) used = respond(*law.curve, law.state, after).plasticWork;
    if (law.kind == LawKind::Constant) used = f1 * (after - before);
    return law.share * (f1 * (after - before) - (storedEnergy(law, f1) - storedEnergy(law, f0)) - used);
}

void keepBooks(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
               const Eigen::VectorXd& d) {
    const Eigen::VectorXd net = netForce(problem, d);
    state.energy.external += external.dot(d);
    for (Eigen::Index i = 0; i < d.size(); ++i)
        if (problem.known[static_cast<std::size_t>(i)]) state.energy.external -= net[i] * d[i];
    std::vector<double> after;
    linkStrains(problem, d, after);
    for (std::size_t i = 0; i < after.size(); ++i)
        state.energy.damped += lawLoss(problem.links[i].law, problem.links[i].strain, after[i]);
    for (std::size_t i = 0; i < model.blocks.size(); ++i) {
        const Eigen::Vector3d strain = d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
        state.energy.damped += 0.5 * model.blocks[i].area * model.thickness * strain.dot(model.blocks[i].elasticity * strain);
    }
}

/// At its zero point, or past it and carrying.
bool touches(const Model& model, const Contact& c) { return c.gap - c.gapOffset <= 10.0 * model.tolerance; }

/// Only touching contacts act while preload is sought; bolts and supports keep the force they have.
void keepTouching(const Model& model, const State& state, StepProblem& problem) {
    for (Link& link : problem.links) {
        if (link.kind == LinkKind::Support || link.kind == LinkKind::Glue) continue;
        if (link.kind == LinkKind::Normal || link.kind == LinkKind::Friction) {
            if (touches(model, state.contacts[static_cast<std::size_t>(link.owner)])) continue;
            link.law = {};
        } else {
            const double force = respond(link.law, link.strain).force;
            link.law.kind = LawKind::Constant;
            link.law.limit = force;
        }
    }
}

/// Moves the contacts' zero points and the blocks' stress so that they carry the forces found, with nothing moved.
void takePreload(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.law.stiffness <= 0.0) continue;
        const double offset = link.strain - respond(link.law, strains[i]).force / link.law.stiffness;
        if (link.kind == LinkKind::Normal) state.contacts[static_cast<std::size_t>(link.owner)].gapOffset = offset;
        if (link.kind == LinkKind::Friction) state.contacts[static_cast<std::size_t>(link.owner)].slipOffset = offset;
        if (link.kind == LinkKind::Glue)
            state.glue[static_cast<std::size_t>(link.owner)].offset[static_cast<std::size_t>(link.part)] = offset;
    }
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        state.blocks[i].preStress +=
            model.blocks[i].elasticity * d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
}

}  // namespace

DynamicStage::DynamicStage(Engine& engine, const Loads& loads, std::function<LoadPoint(double)> loadsAt,
                           DynamicSettings settings)
    : engine_(engine), loads_(loads), loadsAt_(std::move(loadsAt)), settings_(settings), dt_(settings.timeStep) {}

StepEnding DynamicStage::preload(State& state) {
    const Model& model = engine_.model;
    const bool fresh = std::any_of(state.contacts.begin(), state.contacts.end(), [&](const Contact& c) {
        return touches(model, c) && c.normalForce == 0.0 && c.shearForce == 0.0;
    });
    if (!fresh) return {};
    double mass = 0.0, stiffness = std::numeric_limits<double>::max();
    for (const BlockModel& block : model.blocks) mass = std::max(mass, block.mass);
    for (const Contact& c : state.contacts) stiffness = std::min(stiffness, contactStiffness(model, c.blockA, c.blockB));
    if (mass <= 0.0) return {};
    const double dt = std::sqrt(2.0 * mass / (preloadInertia * stiffness));
    State trial = state;
    for (int round = 0; round < preloadRounds; ++round) {
        StepProblem problem = buildStep(model, trial, loads_, loadsAt_(0.0), {Inertia::Static, dt, round == 0});
        keepTouching(model, trial, problem);
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        const SolveReport report = solveStep(engine_, problem, trial, d, model.analysis.tolerance);
        if (report.stopped) return {Ending::Stopped, "", {}};
        if (!report.converged) break;  // what was found so far is a fair start
        takePreload(model, trial, problem, d);
    }
    state = std::move(trial);
    return {};
}

double DynamicStage::predictedMove(const State& state, double dt) const {
    const Model& model = engine_.model;
    double speed = 0.0;
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        speed = std::max(speed, state.blocks[i].velocity.head<2>().norm() +
                                    std::abs(state.blocks[i].velocity[2]) * 2.0 * model.blocks[i].size);
    return std::max(lastMove_, speed * dt + 0.5 * model.gravity.norm() * dt * dt);
}

DynamicStage::Attempt DynamicStage::attempt(const State& state, double time, double dt, Trial& trial) {
    const Model& model = engine_.model;
    const LoadPoint at = loadsAt_(time + dt);
    const double least = nearShare * smallestSize(model);
    double margin = std::max(least, 2.0 * predictedMove(state, dt));
    for (;;) {
        trial.state = state;
        trial.state.contacts = findContacts(model, state.blocks, state.contacts, 2.0 * margin, false);
        StepProblem problem = buildStep(model, trial.state, loads_, at, {settings_.scheme, dt, false});
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        for (std::size_t i = 0; i < model.blocks.size(); ++i)
            d.segment<6>(6 * static_cast<Eigen::Index>(i)) = dt * state.blocks[i].velocity;
        const SolveReport report = solveStep(engine_, problem, trial.state, d, model.analysis.tolerance);
        worst_ = report.worst;
        if (report.stopped) return Attempt::Stopped;
        if (!report.converged) return Attempt::TooLong;
        const double move = largestMove(model, problem, d);
        if (move > margin) {  // something may have been met that was not looked for
            margin = 2.0 * move;
            if (margin > 0.25 * smallestSize(model) && !state.contacts.empty()) return Attempt::TooLong;
            continue;
        }
        lastMove_ = move;
        double total = 0.0;
        const Eigen::VectorXd external = externalForce(model, trial.state, loads_, at, total);
        keepBooks(model, trial.state, problem, external, d);
        acceptStep(model, trial.state, problem, d);
        moveOn(model, trial.state, problem, d, settings_.scheme, dt);
        trial.residual = report.residual;
        return Attempt::Settled;
    }
}

StepEnding DynamicStage::step(State& state, double& time, double end, StepObserver& observer) {
    const Model& model = engine_.model;
    const double rest = end - time;
    double dt = dt_ >= rest * (1.0 - 1e-9) ? rest : dt_;
    const std::vector<Limit> before = heldLimits(model, state);
    const auto start = worstLimit(before, 0.0);
    const double startRatio = start ? std::min(start->ratio, 1.0) : 0.0;
    Trial trial;
    double low = 0.0, high = 0.0;  // bracket of the first limit, once it is known to be passed
    for (int tries = 0;; ++tries) {
        const Attempt attempted = attempt(state, time, dt, trial);
        if (attempted == Attempt::Stopped) return {Ending::Stopped, "", {}};
        if (attempted == Attempt::TooLong) {
            ++engine_.health.stepCuts;
            dt *= 0.3;
            dt_ = dt;
            if (dt >= shortestStep * settings_.timeStep) continue;
            StepEnding failed{Ending::Failed, "no time step settles near " + nameOfBody(model, worst_), {}};
            if (blockOfBody(model, worst_) >= 0) failed.blocks.push_back(worst_);
            return failed;
        }
        const auto worst = worstLimit(heldLimits(model, trial.state), 0.0);
        const double ratio = worst ? worst->ratio : 0.0;
        if (ratio > 1.0 + locateShare) high = dt;
        else low = dt;
        const bool located = high == 0.0 || ratio >= 1.0 - locateShare;
        if ((ratio <= 1.0 + locateShare && located) || high - low <= eventStep * settings_.timeStep || tries > 40) break;
        const double share = tries % 2 == 0 && high == dt ? (1.0 - startRatio) / (ratio - startRatio) : 0.5;
        dt = share == 0.5 ? 0.5 * (low + high) : std::clamp(share * dt, low, high);
        if (dt <= low) dt = 0.5 * (low + high);
    }
    state = std::move(trial.state);
    time = dt == rest ? end : time + dt;
    dt_ = std::min(2.0 * std::max(dt_, dt), settings_.timeStep);
    ++state.step;
    countAccepted(engine_, state, trial.residual);
    double least = high > 0.0 ? 1.0 - locateShare : 1.0 + reachedShare;
    while (const auto limit = worstLimit(heldLimits(model, state), least)) {
        releaseAndTell(model, state, *limit, time, observer);
        observer.afterEvent(state, time);
        least = 1.0 + reachedShare;
    }
    followBolts(model, state);
    return {};
}

}  // namespace keyblock
