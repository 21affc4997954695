// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From state and loads to the matrices and links of a step.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

/// Everything of one step from where `state` is; its contacts were found for it.
StepProblem buildStep(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                      const StepOptions& options);

/// Displacement of a motion's block along its axis since the start of the run [m].
double displacementAlong(const Model& model, const State& state, const PrescribedMotion& motion);

}  // namespace keyblock
