// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction limits that follow normal forces. Each trial uses the limits from its own
// normal forces, and the Newton direction includes their change (coupled_friction.h).
#pragma once

#include "solver/engine/step/step_problem.h"

namespace keyblock {

/// Sets the limit of the link `pair.limited` to the value that follows from the force of the link `pair.from`.
/// \param force the force of `pair.from` in the step's equilibrium, not multiplied by `Law::share` [N].
void setLimit(StepProblem& problem, const LimitPair& pair, double force);

/// Updates the limits of all pairs in `problem.limitPairs` to the forces at displacement `d`.
void correctFrictionLimits(StepProblem& problem, const Eigen::VectorXd& d);

}  // namespace keyblock
