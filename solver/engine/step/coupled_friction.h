// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton direction with sliding friction. A sliding force changes with its normal
// force, which makes the matrix unsymmetric. The symmetric part is factored, and a
// few iterations of GMRES (Saad and Schultz 1986) account for the rest (theory, "The
// step").
#pragma once

#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/trial.h"

namespace keyblock {

struct Direction {
    Eigen::VectorXd displacement;  // padded
    bool slides = false;  // some friction link slides, so the energy need not decrease along this direction
    bool coupled = true;  // friction limits follow their normal forces along this direction; otherwise they are fixed
    /// The coupled solution if the energy would increase along it; empty otherwise.
    Eigen::VectorXd uphill{};
};

/// Solves (A + C)·x = f for the displacement x, where f is the net force of the trial `at`. A is the step matrix for
/// the tangents of the trial; C accounts for the dependence of sliding friction on its normal forces. Without sliding,
/// the solution is accurate to round-off. With sliding, the error f − (A + C)·x is at most a few per cent of f and
/// decreases with `residual`. If this accuracy is not reached, or if x is not a descent direction, C is left out.
/// \param matrix contains an exact or approximate factorisation of A.
/// \param residual the relative unbalanced force of the trial.
/// \param accurate true to reduce the error to a ten-thousandth of f, with more iterations.
/// \return x, padded and zero for prescribed unknowns.
Direction coupledDirection(const StepProblem& problem, const LinkRows& rows, const Trial& at, StepMatrix& matrix,
                           double residual, bool accurate, StepWork& work);

}  // namespace keyblock
