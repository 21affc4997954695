// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Builds the matrices and links of a step from state and loads.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

/// Builds the complete problem of a step from `state`.
/// \pre the contacts in `state` have been found for this step.
StepProblem buildStep(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                      const StepOptions& options);

/// Displacement of the block `motion.block` along `motion.axis` since the start of the run [m].
double displacementAlong(const Model& model, const State& state, const PrescribedMotion& motion);

}  // namespace keyblock
