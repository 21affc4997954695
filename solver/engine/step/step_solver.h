// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solves a step by Newton's method with friction limits that follow their normal
// forces and an exact line search, and by sweeps over the contact forces where the
// line search finds no way through the changing states (theory, "The step").
#pragma once

#include "solver/engine/step/dual_sweeps.h"
#include "solver/engine/step/step_matrix.h"

#include <functional>

namespace keyblock {

struct SolveSettings {
    double tolerance = 1e-4;
    int maxPasses = 40;
    bool openClose = false;  // by the classical iteration
    bool again = false;  // the step has been solved before for nearly the same contacts: begin where that ended
    int sweepsFrom = 0;  // iterations after which sweeps are tried
    bool* sweepsFirst = nullptr;  // in motion: whether the last step took sweeps; kept for the next
};

struct SolveReport {
    bool converged = false;
    bool stopped = false;
    double residual = 0.0;  // over the forces at play
    int passes = 0;  // iterations
    StepWork work;
    int worst = -1;  // body with the largest residual, or whose pivot vanished
    bool singular = false;
};

/// Keeps what is worth keeping between steps: the pattern of the matrix and its symbolic factor.
class StepSolver {
public:
    /// Balances the step from the better of `d` and no displacement (prescribed values are put in
    /// first). Leaves the displacement in `d` and the friction limits that belong to it in `problem`.
    SolveReport solve(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                      const std::function<bool()>& stopAsked);

    /// Entries of the last factor, zeros that it stores included.
    double factorEntries() const { return matrix_.factorEntries(); }

private:
    class Newton;

    SolveReport openClose(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                          const std::function<bool()>& stopAsked);

    StepMatrix matrix_;
};

inline constexpr double quietStart = 1e-9;  // a start this well balanced needs no solve

/// Body that an unknown belongs to.
int bodyOf(const StepProblem& problem, int unknown);

}  // namespace keyblock
