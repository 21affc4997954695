// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/preload.h"

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double preloadInertia = 1e-7;  // over the contact springs, while preload is sought
constexpr int preloadRounds = 4;
constexpr double rough = 10.0;  // times the tolerance, in a scene that moves: its first step solves for the rest
constexpr int preloadPasses = 12;  // iterations with friction: a scene that is far from rest after these moves
constexpr double nearRest = 1e-3;  // residual from which rest is sought with all iterations
constexpr double restful = 1e-7;  // residual that is then enough, whatever the tolerance: contacts hold such a scene

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

/// Moves the contacts' zero points and the blocks' stress so that they carry the forces found, with nothing moved. What
/// friction could not hold is not kept: it would fail at once, with an energy that came from nowhere.
void keepForces(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    double push = 0.0;
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.law.stiffness <= 0.0) continue;
        const double force = respond(link.law, strains[i]).force;
        if (link.kind == LinkKind::Normal) {
            carryNormal(model, state.contacts[static_cast<std::size_t>(link.owner)], link.strain, -force);
            push = std::max(0.0, -force);
        }
        if (link.kind == LinkKind::Friction) {
            Contact& c = state.contacts[static_cast<std::size_t>(link.owner)];
            const double most = c.bonded ? std::abs(force) : frictionOf(model, c) * push;
            carryShear(model, c, link.strain, std::clamp(force, -most, most));
        }
        if (link.kind == LinkKind::Glue)
            state.glue[static_cast<std::size_t>(link.owner)].offset[static_cast<std::size_t>(link.part)] =
                link.strain - force / link.law.stiffness;
    }
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        state.blocks[i].preStress +=
            model.blocks[i].elasticity * d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
}

void stop(State& state) {
    for (BlockMotion& block : state.blocks) block.velocity.setZero();
    for (BoltMotion& bolt : state.bolts)
        for (BoltNode& node : bolt.nodes) node.velocity.setZero();
}

void takeVelocities(const State& from, State& to) {
    for (std::size_t i = 0; i < from.blocks.size(); ++i) to.blocks[i].velocity = from.blocks[i].velocity;
    for (std::size_t b = 0; b < from.bolts.size(); ++b)
        for (std::size_t n = 0; n < from.bolts[b].nodes.size(); ++n)
            to.bolts[b].nodes[n].velocity = from.bolts[b].nodes[n].velocity;
}

/// Pseudo-step whose inertia is soft compared with the softest contact [s]; 0 where nothing has mass.
double preloadStep(const Model& model, const State& state) {
    double mass = 0.0, stiffness = std::numeric_limits<double>::max();
    for (const BlockModel& block : model.blocks) mass = std::max(mass, block.mass);
    for (const Contact& c : state.contacts) stiffness = std::min(stiffness, contactSprings(model, c).normal);
    return std::sqrt(2.0 * mass / (preloadInertia * stiffness));
}

}  // namespace

bool takePreload(Engine& engine, State& state, const Loads& loads, const LoadPoint& first, double timeStep) {
    const Model& model = engine.model;
    const bool fresh = std::any_of(state.contacts.begin(), state.contacts.end(), [&](const Contact& c) {
        return touches(model, c) && c.normalForce == 0.0 && c.shearForce == 0.0;
    });
    const double dt = fresh ? preloadStep(model, state) : 0.0;
    if (dt == 0.0) return true;
    State trial = state;
    stop(trial);
    StepOptions options{Inertia::Static, dt, true};
    StepNeeds needs{.tolerance = model.analysis.tolerance, .convex = true};
    for (int round = 0; round < preloadRounds; ++round) {
        StepProblem problem = buildStep(model, trial, loads, first, options);
        keepTouching(model, trial, problem);
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        SolveReport report = solveStep(engine, problem, trial, d, needs);
        const bool slow = options.inertia == Inertia::Static && !report.converged && report.residual <= nearRest;
        if (slow && !report.stopped)
            report = solveStep(engine, problem, trial, d, {.tolerance = std::max(restful, needs.tolerance), .convex = true});
        if (report.stopped) return false;
        if (report.converged) keepForces(model, trial, problem, d);
        if (options.inertia != Inertia::Static) break;
        options.frictionLocked = false;
        needs.maxPasses = std::min(model.analysis.maxPasses, preloadPasses);
        if (!report.converged) {
            options = {Inertia::Shi, timeStep};
            needs = {.tolerance = rough * model.analysis.tolerance, .convex = true};
        }
    }
    takeVelocities(state, trial);
    state = std::move(trial);
    return true;
}

}  // namespace keyblock
