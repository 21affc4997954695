// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far to go along a direction: to where the net force has no part along it any
// more. With the friction limits as they are that is where the step's convex energy is
// least.
#pragma once

#include "solver/engine/step/trial.h"

namespace keyblock {

/// Step length in (0, 1] at which the slope vanishes; 1 where it still falls there.
/// \param coupled friction limits follow their normal forces along the way (and are left as they are at the last length
/// that was tried); else they stay as they are.
/// \param rates of the links' strains along `direction`.
double lineSearch(StepProblem& problem, const Trial& from, const Eigen::VectorXd& direction,
                  const std::vector<double>& rates, bool coupled);

}  // namespace keyblock
