// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Acceptance of a solved step: stores forces and history in the state, moves the
// bodies, and accounts for the energy dissipated by friction and plastic flow.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// Moves blocks and bolt nodes by the step's displacement `d`; laws and forces are not changed.
void moveBodies(const Model& model, State& state, const Eigen::VectorXd& d);

/// Accepts a step: stores the forces and the new history of the links at displacement `d`, moves the bodies, and
/// accounts for the energy dissipated by friction and plastic flow. The caller must update the velocities.
void acceptStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
