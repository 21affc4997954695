// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction limits follow normal forces. Within a trial they are those of its own
// normal forces; a direction of Newton's takes along how they change
// (`CoupledFriction`), so that no limit lags behind.
#pragma once

#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// Sets the limit of a pair from the force that its other link gives to the step's balance, before its share [N].
void setLimit(StepProblem& problem, const LimitPair& pair, double force);

/// Sets every limit that follows another force to what the forces at `d` allow.
void correctFrictionLimits(StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
