// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's direction where friction slides. A sliding force changes with its normal
// force, which makes the matrix unsymmetric: the symmetric part is factored, and a
// few steps of GMRES (Saad and Schultz 1986) bring in the rest (theory, "The step").
#pragma once

#include "solver/engine/step/step_matrix.h"
#include "solver/engine/step/trial.h"

namespace keyblock {

struct Direction {
    Eigen::VectorXd displacement;  // padded
    bool slides = false;  // friction slides: no energy falls along it for certain
    bool coupled = true;  // friction limits follow along it; else they stay as they are
};

/// Solves (A + C)·x = net force of `at`, where A is the matrix of the step for the tangents there, of which `matrix` holds
/// a factor or nearly one, and C is how sliding friction follows its normal forces. Where friction slides, to a few
/// hundredths of the net force, which is closer the nearer `at` is to balance (`residual`); else to round-off. Padded, zero
/// where prescribed. Where that is not reached, or leads uphill, C is left out.
Direction coupledDirection(const StepProblem& problem, const LinkRows& rows, const Trial& at, StepMatrix& matrix,
                           double residual, StepWork& work);

}  // namespace keyblock
