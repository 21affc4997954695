// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step at rest: Newton with exact line search on the convex energy under given
// friction limits, and around it their correction from the normal forces. Inertia is
// only a regularisation there, so next to nothing may resist a block that slides on
// all sides: limits that follow within an iteration would let it drift.
#include "solver/engine/step/balance.h"
#include "solver/engine/step/limit_rounds.h"
#include "solver/engine/step/line_search.h"
#include "solver/engine/step/step_forces.h"
#include "solver/engine/step/step_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr int patience = 2, boltPatience = 12;  // passes before a step is helped over flat laws of joints, and of bolts
constexpr double flatMatters = 1e-6;  // of the forces at play, unbalanced: joints are helped over no less
constexpr double lowestFloor = 1e-6, highestFloor = 0.1;  // of a law's stiffness

/// Shares of a law's stiffness that no tangent is taken as less than.
struct LawFloor {
    double bolts = 0.0, joints = 0.0;
};

/// Where laws are flat, of open joints too, a step of Newton's goes far and is stopped early by the first law that is
/// not: then laws are taken as stiffer than they are, until steps go through again.
double nextFloor(double floor, double stepLength) {
    if (stepLength < 0.05) return std::clamp(10.0 * floor, lowestFloor, highestFloor);
    if (stepLength > 0.5) return floor > lowestFloor ? 0.1 * floor : 0.0;
    return floor;
}

/// Nearly balanced, what is left of joints is friction at its limit to the last digits, where blocks slide to and fro.
LawFloor floorFrom(double floor, int passes, double residual) {
    return {passes > boltPatience ? floor : 0.0, residual > flatMatters ? floor : 0.0};
}

/// Judges a displacement under the limits as they are.
Trial underLimits(const StepProblem& problem, Eigen::VectorXd d, SolveReport& report) {
    report.work.products += 2;
    Trial trial;
    trial.d = std::move(d);
    const Eigen::VectorXd own = unpadded(trial.d);
    linkStrains(problem, own, trial.strains);
    for (std::size_t i = 0; i < problem.links.size(); ++i)
        trial.laws.push_back(respond(problem, problem.links[i], trial.strains[i]));
    trial.net = padded(netForce(problem, own));
    return trial;
}

Balance judge(const StepProblem& problem, const LinkRows& rows, const Trial& trial, SolveReport& report) {
    Balance balance(problem, rows, trial, report.passes, 0.0);
    report.residual = balance.residual();
    report.worst = balance.worst();
    return balance;
}

/// Factors the matrix at a trial; no law is taken as softer than its floor. \return false where it is singular.
bool makeFactor(const StepProblem& problem, const LinkRows& rows, const Trial& trial, const LawFloor& floor,
                StepMatrix& matrix, SolveReport& report) {
    std::vector<double> weights(rows.count());
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Link& link = problem.links[i];
        const double least = link.part >= 0 ? floor.bolts : floor.joints;
        weights[i] = link.law.share * std::max(trial.laws[i].tangent, least * link.law.stiffness);
    }
    matrix.forget();
    const int loose = matrix.factor(problem, rows, weights, report.work);
    if (loose < 0) return true;
    report.singular = true;
    report.worst = bodyOf(problem, loose);
    return false;
}

/// Goes along Newton's direction to where the energy is least. \return the step's length.
double takeStep(StepProblem& problem, StepMatrix& matrix, Trial& trial, SolveReport& report) {
    const Eigen::VectorXd direction = matrix.solve(trial.net, report.work);
    std::vector<double> rates;
    linkStrains(problem, unpadded(trial.d + direction), rates);
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] -= trial.strains[i];
    const double length = lineSearch(problem, trial, direction, rates, false);
    trial = underLimits(problem, trial.d + length * direction, report);
    ++report.work.products;
    return length;
}

}  // namespace

SolveReport StepSolver::inRounds(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                                 const std::function<bool()>& stopAsked) {
    SolveReport report;
    const LinkRows rows(problem);
    matrix_.begin(problem, rows);
    LimitRounds rounds;
    double floor = 0.0;
    Trial trial = underLimits(problem, padded(d), report);
    const auto leave = [&] {
        d = unpadded(trial.d);
        return report;
    };
    for (; report.passes <= settings.maxPasses; ++report.passes) {
        report.stopped = stopAsked && stopAsked();
        if (report.stopped) return leave();
        Balance balance = judge(problem, rows, trial, report);
        if (!std::isfinite(report.residual)) return leave();
        const double tolerance = report.passes == 0 ? std::min(quietStart, settings.tolerance) : settings.tolerance;
        if (balance.within(tolerance)) {  // under the limits assumed: now under the true ones
            rounds.correct(problem, unpadded(trial.d));
            trial = underLimits(problem, trial.d, report);
            balance = judge(problem, rows, trial, report);
            report.converged = balance.within(tolerance);
            if (report.converged) return leave();
            if (rounds.mix(problem)) trial = underLimits(problem, trial.d, report);
        }
        const LawFloor floors = floorFrom(floor, report.passes, report.residual);
        if (!makeFactor(problem, rows, trial, floors, matrix_, report)) {
            floor = std::max(floor, lowestFloor);
            if (!makeFactor(problem, rows, trial, {floor, floor}, matrix_, report)) return leave();
        }
        const double length = takeStep(problem, matrix_, trial, report);
        if (report.passes < patience) continue;
        floor = nextFloor(floor, length);
        report.lost = farthestMove(problem, trial.d) > settings.farthest;
        if (report.lost) return leave();
    }
    return leave();
}

}  // namespace keyblock
