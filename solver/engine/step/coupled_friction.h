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
};

/// Solves (A + C)·x = net force at `at`. A is the step matrix for the tangents at `at`, and `matrix` contains an exact
/// or approximate factorisation of A; C is the dependence of sliding friction on its normal forces. Without sliding
/// the solution is accurate to round-off; with sliding, to a few per cent of the net force or better, more closely as
/// `residual` decreases. If this accuracy is not reached, or the result is not a descent direction, C is left out. The
/// displacement is padded and zero for prescribed unknowns.
Direction coupledDirection(const StepProblem& problem, const LinkRows& rows, const Trial& at, StepMatrix& matrix,
                           double residual, StepWork& work);

}  // namespace keyblock
