// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The classical open–close iteration (Shi 1988): solve with the states of all contacts
// fixed (open, sliding, locked), determine the states again from the solution, and
// repeat until none changes. It may cycle endlessly; the time step is then reduced. It
// is kept as a reference for the convex step, which has the same mechanics.
#include "solver/engine/step/balance.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/step/step_solver.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// iterations after which the remaining force may be round-off: with fixed states a step is linear
constexpr int mayBeRoundOff = 2;

/// State of a law: closed or sticking (`Held`), sliding backwards or forwards, or open.
enum class LinkState : signed char { Backward = -1, Held = 0, Forward = 1, Open = 2 };

LinkState stateOf(const Law& law, double strain) {
    const double trial = law.stiffness * (strain - law.offset);
    if (law.kind == LawKind::Gap) return trial <= 0.0 ? LinkState::Held : LinkState::Open;
    if (law.kind != LawKind::Capped) return LinkState::Held;
    return trial > law.limit ? LinkState::Forward : trial < -law.limit ? LinkState::Backward : LinkState::Held;
}

std::vector<LinkState> judge(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    std::vector<LinkState> states(strains.size());
    for (std::size_t i = 0; i < strains.size(); ++i) states[i] = stateOf(problem.links[i].law, strains[i]);
    return states;
}

/// Fixes the state of every contact, whatever the displacement, so that the step becomes linear.
StepProblem held(const StepProblem& problem, const std::vector<LinkState>& states) {
    StepProblem frozen = problem;
    for (std::size_t i = 0; i < states.size(); ++i) {
        Law& law = frozen.links[i].law;
        if (law.kind == LawKind::Gap) {
            law.kind = LawKind::Linear;
            if (states[i] == LinkState::Open) law.stiffness = 0.0;
        } else if (law.kind == LawKind::Capped) {
            law.kind = states[i] == LinkState::Held ? LawKind::Linear : LawKind::Constant;
            if (states[i] != LinkState::Held) law.limit *= static_cast<double>(states[i]);
        }
    }
    return frozen;
}

/// True if no change of state changes a force by more than the tolerance of either body.
bool sameForces(const StepProblem& problem, const StepProblem& frozen, const std::vector<LinkState>& before,
                const std::vector<LinkState>& after, const Eigen::VectorXd& d, const Balance& balance,
                double tolerance) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        if (before[i] == after[i]) continue;
        const Link& link = problem.links[i];
        const double differs =
            std::abs(respond(link.law, strains[i]).force - respond(frozen.links[i].law, strains[i]).force);
        if (differs > balance.slack(link.a, tolerance)) return false;
        if (link.b >= 0 && differs > balance.slack(link.b, tolerance)) return false;
    }
    return true;
}

/// Makes one linear step from `d` with fixed states.
/// \return false if the matrix is singular.
bool solveHeld(const StepProblem& frozen, const LinkRows& rows, StepMatrix& matrix, Eigen::VectorXd& d,
               SolveReport& report) {
    std::vector<double> strains, weights(rows.count());
    linkStrains(frozen, d, strains);
    for (std::size_t i = 0; i < weights.size(); ++i)
        weights[i] = frozen.links[i].law.share * respond(frozen, frozen.links[i], strains[i]).tangent;
    const int loose = matrix.factor(frozen, rows, weights, report.work);
    report.singular = loose >= 0;
    if (report.singular) report.worst = bodyOf(frozen, loose);
    else d += unpadded(matrix.solve(padded(netForce(frozen, d)), report.work));
    return !report.singular;
}

}  // namespace

SolveReport StepSolver::openClose(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                                  const std::function<bool()>& stopAsked) {
    SolveReport report;
    const LinkRows rows(problem);
    matrix_.begin(problem, rows);
    correctFrictionLimits(problem, d);
    std::vector<LinkState> states = judge(problem, d);
    for (report.passes = 1; report.passes <= settings.maxPasses; ++report.passes) {
        if (stopAsked && stopAsked()) {
            report.stopped = true;
            return report;
        }
        const StepProblem frozen = held(problem, states);
        if (!solveHeld(frozen, rows, matrix_, d, report)) return report;
        const Trial trial = trialAt(problem, rows, padded(d));
        const Balance balance(problem, rows, trial, mayBeRoundOff, 0.0);
        report.residual = balance.residual();
        report.worst = balance.worst();
        if (!std::isfinite(report.residual)) return report;
        std::vector<LinkState> next = judge(problem, d);
        const bool settled = sameForces(problem, frozen, states, next, d, balance, settings.tolerance);
        if (settled && balance.within(settings.tolerance)) {
            report.converged = true;
            return report;
        }
        states = std::move(next);
    }
    return report;
}

}  // namespace keyblock
