// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/preload.h"

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/balance.h"
#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

constexpr double restInertia = 1e-7;  // inertia over contact stiffness in the search for rest
constexpr int restRounds = 4;
constexpr int quickPasses = 3;  // iterations with friction after which a scene far from rest is assumed to move
constexpr double nearRest = 1e-3;  // residual up to which the search for rest continues with all iterations
constexpr double restTolerance = 1e-7;  // minimum tolerance of that second search
constexpr double movingTolerance = 10.0;  // times the tolerance of the scene: the first time step corrects the error

/// True if a contact is closed: at its zero point or compressed.
bool touches(const Model& model, const Contact& c) { return c.gap - c.gapOffset <= 10.0 * model.tolerance; }

/// True if anything acts on blocks at rest: a load, a prescribed motion, or a force of a joint, bolt, support or glue.
bool isLoaded(const State& state, const StepProblem& problem) {
    const auto carries = [&](const Link& link) {
        return !ofContact(link.kind) && respond(problem, link, link.strain + link.shift).force != 0.0;
    };
    const auto pushes = [](const Contact& c) { return c.bonded || c.normalForce != 0.0 || c.shearForce != 0.0; };
    return !problem.load.isZero(0.0) || !problem.value.isZero(0.0) ||
           std::any_of(state.contacts.begin(), state.contacts.end(), pushes) ||
           std::any_of(problem.links.begin(), problem.links.end(), carries);
}

/// Shifts the zero points of touching contacts so that they carry no force, although their corners meet only to within
/// round-off.
void carryNothing(const Model& model, State& state) {
    for (Contact& c : state.contacts) {
        if (!touches(model, c)) continue;
        carryNormal(model, c, gapOf(state.blocks, c), 0.0);
        carryShear(model, c, slipOf(state.blocks, c), 0.0);
    }
}

/// Keeps only touching contacts, supports and glue active while the preload is calculated; bolts keep their current
/// forces.
void keepTouching(const Model& model, const State& state, StepProblem& problem) {
    for (Link& link : problem.links) {
        if (link.kind == LinkKind::Support || link.kind == LinkKind::Glue) continue;
        if (link.kind == LinkKind::Normal || link.kind == LinkKind::Friction) {
            if (touches(model, state.contacts[link.owner])) continue;
            link.law = {};
        } else {
            const double force = respond(link.law, link.strain).force;
            link.law.kind = LawKind::Constant;
            link.law.limit = force;
        }
    }
}

/// Shifts the zero points of contacts and glue and the stress of the blocks so that they carry the forces found without
/// any movement. Shear forces beyond the friction limit are not kept: the contact would slip at once and release energy
/// that no load has supplied.
void keepForces(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    double push = 0.0;
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.law.stiffness <= 0.0) continue;
        const double force = respond(link.law, strains[i]).force;
        if (link.kind == LinkKind::Normal) {
            carryNormal(model, state.contacts[link.owner], link.strain, -force);
            push = std::max(0.0, -force);
        }
        if (link.kind == LinkKind::Friction) {
            Contact& c = state.contacts[link.owner];
            const double most = c.bonded ? std::abs(force) : frictionOf(model, c) * push;
            carryShear(model, c, link.strain, std::clamp(force, -most, most));
        }
        if (link.kind == LinkKind::Glue)
            state.glue[link.owner].offset[link.part] =
                link.strain - force / link.law.stiffness;
    }
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        state.blocks[i].preStress +=
            model.blocks[i].elasticity * d.segment<3>(6 * static_cast<Eigen::Index>(i) + 3);
}

void restoreVelocities(const State& from, State& to) {
    for (std::size_t i = 0; i < from.blocks.size(); ++i) to.blocks[i].velocity = from.blocks[i].velocity;
    for (std::size_t b = 0; b < from.bolts.size(); ++b)
        for (std::size_t n = 0; n < from.bolts[b].nodes.size(); ++n)
            to.bolts[b].nodes[n].velocity = from.bolts[b].nodes[n].velocity;
}

/// Length of a pseudo-step whose inertia is small compared with the softest contact [s]; 0 if no block has mass.
double restStep(const Model& model, const State& state) {
    double mass = 0.0, stiffness = std::numeric_limits<double>::max();
    for (const BlockModel& block : model.blocks) mass = std::max(mass, block.mass);
    for (const Contact& c : state.contacts) stiffness = std::min(stiffness, contactSprings(model, c).normal);
    return std::sqrt(2.0 * mass / (restInertia * stiffness));
}

/// Calculates the forces of one round and stores them if it converges.
class PreloadSearch {
public:
    PreloadSearch(Engine& engine, State& state, const Loads& loads, const LoadPoint& first)
        : engine_(engine), state_(state), loads_(loads), first_(first) {}

    /// True if no force acts on the blocks; their touching contacts then carry no force.
    bool isFreeOfForces(double dt) {
        begin({Inertia::Static, dt, true});
        if (isLoaded(state_, problem_)) return false;
        carryNothing(engine_.model, state_);
        return true;
    }

    /// True if the forces that contacts carry balance so well that the first time step from rest needs no solution.
    bool isBalanced(double timeStep) {
        begin({Inertia::Shi, timeStep});
        const LinkRows rows(problem_);
        const double tolerance = engine_.model.numerics.tolerance;
        const Trial still = trialAt(problem_, rows, padded(d_));
        return Balance(problem_, rows, still, 0, tolerance).within(balancedInMotion * tolerance);
    }

    /// Finds the forces in several rounds at rest, or if one of them does not converge, in the first time step.
    /// \return false if the run was stopped.
    bool find(double dt, double timeStep) {
        for (int round = 0; round < restRounds; ++round) {
            const SolveReport report = atRest(dt, round == 0);
            if (report.stopped) return false;
            if (!report.converged) return !moving(timeStep).stopped;
        }
        return true;
    }

private:
    /// Makes a round at rest. With friction, a scene that is near rest after a few iterations is allowed all
    /// iterations.
    SolveReport atRest(double dt, bool frictionLocked) {
        begin({Inertia::Static, dt, frictionLocked});
        const Numerics& numerics = engine_.model.numerics;
        const int passes = frictionLocked ? 0 : std::min(numerics.maxPasses, quickPasses);
        const SolveReport report = solve({.tolerance = numerics.tolerance, .maxPasses = passes});
        if (report.converged || report.stopped || report.residual > nearRest) return report;
        return solve({.tolerance = std::max(restTolerance, numerics.tolerance)});
    }

    /// Makes the first time step of the scene from rest.
    SolveReport moving(double timeStep) {
        begin({Inertia::Shi, timeStep});
        SweepsFirst sweepsFirst{.left = 1};
        return solve({.tolerance = movingTolerance * engine_.model.numerics.tolerance, .sweepsFirst = &sweepsFirst});
    }

    void begin(const StepOptions& options) {
        problem_ = buildStep(engine_.model, state_, loads_, first_, options);
        keepTouching(engine_.model, state_, problem_);
        d_ = Eigen::VectorXd::Zero(problem_.unknowns());
    }

    SolveReport solve(StepNeeds needs) {
        needs.convex = true;
        const SolveReport report = solveStep(engine_, problem_, state_, d_, needs);
        if (report.converged) keepForces(engine_.model, state_, problem_, d_);
        return report;
    }

    Engine& engine_;
    State& state_;
    const Loads& loads_;
    const LoadPoint& first_;
    StepProblem problem_;
    Eigen::VectorXd d_;
};

bool isFresh(const Model& model, const State& state) {
    return std::any_of(state.contacts.begin(), state.contacts.end(), [&](const Contact& c) {
        return touches(model, c) && c.normalForce == 0.0 && c.shearForce == 0.0;
    });
}

}  // namespace

bool takePreload(Engine& engine, State& state, const Loads& loads, const LoadPoint& first, double timeStep) {
    const double dt = isFresh(engine.model, state) ? restStep(engine.model, state) : 0.0;
    if (dt == 0.0) return true;
    State trial = state;
    stopMotion(trial);
    PreloadSearch search(engine, trial, loads, first);
    if (search.isBalanced(timeStep)) return true;
    if (!search.isFreeOfForces(dt) && !search.find(dt, timeStep)) return false;
    restoreVelocities(state, trial);
    state = std::move(trial);
    return true;
}

}  // namespace keyblock
