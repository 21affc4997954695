// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Augmented Lagrangian: contact forces that need no penetration and no elastic
// slip. After each solution the springs' forces become multipliers, and the
// step is solved again, until the springs have nothing left to do (theory,
// "Augmented Lagrangian"). Joints with a stiffness of their own keep it.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// True where the scene asks for it.
bool usesMultipliers(const Model& model);

/// Largest penetration or elastic slip at `d`, over what is allowed: 1e-9 of the smaller block.
double multiplierError(const Model& model, const State& state, const StepProblem& problem, const Eigen::VectorXd& d);

/// Takes the forces at `d` as the multipliers of the contacts, in the state and in the laws of the step, whose springs
/// become `stiffer` times as stiff.
void takeMultipliers(State& state, StepProblem& problem, const Eigen::VectorXd& d, double stiffer);

/// Leaves multipliers in the state under which the springs as the scene has them carry the forces at `d`.
void keepMultipliers(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
