// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction limits follow normal forces. Every trial has the limits of its own normal
// forces, and Newton's direction includes how they change (coupled_friction.h).
#pragma once

#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// Sets the limit of a pair from the force that its other link gives to the step's balance, before its share [N].
void setLimit(StepProblem& problem, const LimitPair& pair, double force);

/// Sets every limit that follows another force to what the forces at `d` allow.
void correctFrictionLimits(StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
