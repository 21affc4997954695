// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/engine.h"

#include "solver/engine/contact/multipliers.h"
#include "solver/engine/stage/limits.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

long releaseAndReport(const Model& model, State& state, const Limit& limit, double time, long cause,
                      StepObserver& observer) {
    const State before = state;
    std::vector<Event> events = releaseLimit(model, state, limit);
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (i > 0) observer.afterEvent(before, time);
        observer.beforeEvent(before, time);
        events[i].cause = cause;
        cause = observer.event(events[i], before, time);  // the loss of a bolt is caused by its anchor
    }
    return cause;
}

namespace {

constexpr int mostUpdates = 40;  // updates of the multipliers in one step
constexpr double slowUpdate = 0.1;  // of the previous error: if more is left, the springs are stiffened
constexpr double stiffer = 10.0;
constexpr double stiffest = 1e4;

/// Solves again with multipliers until contacts neither penetrate nor slip elastically.
void settleMultipliers(Engine& engine, StepProblem& problem, State& state, Eigen::VectorXd& d, SolveSettings settings,
                       SolveReport& report) {
    settings.fromGuess = true;
    double error = multiplierError(engine.model, state, problem, d), errorBefore = error, raised = 1.0;
    for (int update = 0; report.converged && error > 1.0; ++update) {
        const bool raise = update > 0 && error > slowUpdate * errorBefore && raised < stiffest;
        raised *= raise ? stiffer : 1.0;
        takeMultipliers(state, problem, d, raise ? stiffer : 1.0);
        const SolveReport next = engine.solver.solve(problem, d, settings, engine.stopAsked);
        const int passes = report.passes + std::max(1, next.passes);
        const StepWork before = report.work;
        report = next;
        report.passes = passes;
        report.work += before;
        report.converged = report.converged && update < mostUpdates;
        errorBefore = std::exchange(error, multiplierError(engine.model, state, problem, d));
    }
    if (report.converged) keepMultipliers(engine.model, state, problem, d);
}

}  // namespace

SolveReport solveStep(Engine& engine, StepProblem& problem, State& state, Eigen::VectorXd& d, const StepNeeds& needs) {
    const Analysis& analysis = engine.model.analysis;
    const bool openClose = analysis.iteration == Iteration::OpenClose && !needs.convex;
    const int passes = needs.maxPasses > 0 ? needs.maxPasses : engine.model.numerics.maxPasses;
    const SolveSettings settings{needs.tolerance, passes, openClose, needs.fromGuess, needs.sweepsFirst};
    SolveReport report = engine.solver.solve(problem, d, settings, engine.stopAsked);
    if (usesMultipliers(engine.model)) settleMultipliers(engine, problem, state, d, settings, report);
    ++engine.health.steps;
    engine.health.passes += std::max(1, report.passes);
    engine.health.work += report.work;
    ++engine.newest.searched;
    engine.newest.passes = report.passes;
    engine.newest.worst = blockOfBody(engine.model, report.worst);
    for (const LimitPair& pair : problem.limitPairs) {
        const Link& link = problem.links[pair.limited];
        if (link.kind != LinkKind::Friction) continue;
        state.contacts[link.owner].limit = link.law.limit;
    }
    if (engine.passed) engine.passed();
    return report;
}

double blockMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d, std::size_t block) {
    const auto first = 6 * static_cast<Eigen::Index>(block);
    Vector6 own = d.segment<6>(first);
    for (Eigen::Index k = 0; k < 6; ++k)
        if (problem.known[first + k]) own[k] = 0.0;
    double reach = 0.0;
    for (const Point& corner : model.blocks[block].shape) reach = std::max(reach, corner.norm());
    return own.head<2>().norm() + (std::abs(own[2]) + own.tail<3>().cwiseAbs().maxCoeff()) * reach;
}

double nodeMove(const StepProblem& problem, const Eigen::VectorXd& d) {
    double largest = 0.0;
    for (int n = 0; n < problem.nodes; ++n) {
        const int first = problem.first(problem.blocks + n);
        if (!problem.known[first]) largest = std::max(largest, d.segment<2>(first).norm());
    }
    return largest;
}

double largestMove(const Model& model, const StepProblem& problem, const Eigen::VectorXd& d) {
    double largest = nodeMove(problem, d);
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        largest = std::max(largest, blockMove(model, problem, d, i));
    return largest;
}

int blockOfBody(const Model& model, int body) {
    return body < static_cast<int>(model.blocks.size()) ? body : -1;
}

std::string nameOfBody(const Model& model, int body) {
    if (const int block = blockOfBody(model, body); block >= 0)
        return "block " + model.blocks[block].name;
    const int node = body - static_cast<int>(model.blocks.size());
    for (const BoltModel& bolt : model.bolts)
        if (node >= bolt.firstNode && node < bolt.firstNode + static_cast<int>(bolt.s.size()))
            return "node " + std::to_string(node - bolt.firstNode) + " of bolt " + bolt.name;
    return "nothing";
}

void countAccepted(Engine& engine, const State& state, double residual) {
    StepHealth& newest = engine.newest;
    newest.residual = residual;
    newest.penetrationRatio = 0.0;
    newest.penetrated = -1;
    for (const Contact& c : state.contacts) {
        const double depth = c.gapOffset - c.gap;
        const double size = std::min(engine.model.blocks[c.blockA].size,
                                     engine.model.blocks[c.blockB].size);
        if (!(depth / size > newest.penetrationRatio)) continue;
        newest.penetrationRatio = depth / size;
        newest.penetrated = c.blockA;
    }
    engine.health.maxPenetrationRatio = std::max(engine.health.maxPenetrationRatio, newest.penetrationRatio);
    engine.health.maxResidual = std::max(engine.health.maxResidual, residual);
}

}  // namespace keyblock
