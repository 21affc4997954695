// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Augmented Lagrangian method: contact forces without penetration or elastic slip.
// After each solution the forces of the contact springs become multipliers and the step
// is solved again, until the spring deformations vanish (theory, "Augmented
// Lagrangian"). Joints with a stiffness of their own keep it.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// True if the scene uses the augmented Lagrangian method.
bool usesMultipliers(const Model& model);

/// Largest penetration or elastic slip at displacement `d`, divided by the allowed value, which is 1e-9 of the smaller
/// block's size.
double multiplierError(const Model& model, const State& state, const StepProblem& problem, const Eigen::VectorXd& d);

/// Sets the contacts' multipliers to the forces at displacement `d`, in the state and in the step's laws.
/// \param stiffer the factor by which the step's contact springs are stiffened.
void takeMultipliers(State& state, StepProblem& problem, const Eigen::VectorXd& d, double stiffer);

/// Sets the multipliers in the state so that contacts with their original spring stiffness carry the forces at
/// displacement `d`.
void keepMultipliers(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
