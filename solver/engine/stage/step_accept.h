// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After a step was solved: forces and history into the state, bodies to their
// new positions, and the energy that friction and plastic flow used.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// Moves blocks and nodes by the step's displacement; laws and forces stay as they are.
void moveBodies(const Model& model, State& state, const Eigen::VectorXd& d);

/// Accepts the step: takes forces and new history from the links at `d`, moves the bodies, and
/// accounts for what friction and plastic flow used. Velocities are left to the caller.
void acceptStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
