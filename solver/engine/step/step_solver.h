// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a step by Newton's method with an exact line search and friction limits that
// follow their normal forces. If the line search makes no progress because contact
// states keep changing, it sweeps over the contact forces (theory, "The step").
#pragma once

#include "solver/engine/step/dual_sweeps.h"
#include "solver/engine/step/force_trend.h"
#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/sweeps_first.h"

#include <functional>

namespace keyblock {

struct SolveSettings {
    double tolerance = 1e-4;  // unbalanced force over the acting forces
    int maxPasses = 40;  // maximum number of iterations
    bool openClose = false;  // use the classical open–close iteration
    bool fromGuess = false;  // start from the given displacement, even if zero displacement has the smaller residual
    SweepsFirst* sweepsFirst = nullptr;  // in motion: whether the step begins with sweeps; updated for the next one
};

struct SolveReport {
    bool converged = false;
    bool stopped = false;
    double residual = 0.0;  // unbalanced force over the acting forces
    int passes = 0;  // iterations made
    StepWork work;
    int worst = -1;  // body with the largest residual or with a vanishing pivot
    bool singular = false;
};

/// Solver for steps. It keeps the matrix pattern, the ordering, the factor and the trend of the contact forces from step
/// to step.
class StepSolver {
public:
    /// Solves the step. Iteration starts from `d` or from zero displacement, whichever has the smaller residual once
    /// the prescribed values have been inserted, or from zero displacement if that needs no solution or if the step
    /// begins with sweeps. On return, `d` is the solution, and `problem` contains the friction limits for this displacement.
    SolveReport solve(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                      const std::function<bool()>& stopAsked);

    /// Forgets how the contact forces changed in the last step, where the next one does not continue it.
    void forgetTrend() { trend_ = {}; }

    /// Number of entries of the last factor, including stored zeros.
    double factorEntries() const { return matrix_.factorEntries(); }

private:
    class Newton;

    SolveReport openClose(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                          const std::function<bool()>& stopAsked);

    StepMatrix matrix_;
    ForceTrend trend_;
};

/// Fraction of the tolerance up to which the start of a dynamic step may be unbalanced without needing a solution.
inline constexpr double balancedInMotion = 0.1;

/// Index of the body to which an unknown belongs.
int bodyOf(const StepProblem& problem, int unknown);

}  // namespace keyblock
