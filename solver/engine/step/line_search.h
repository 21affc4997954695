// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step length along a direction: the point at which the net force has no component
// along the direction. With fixed friction limits this is the minimum of the step's
// convex energy.
#pragma once

#include "solver/engine/step/trial.h"

#include <optional>

namespace keyblock {

/// Step length in (0, 1] at which the slope of the energy vanishes; 1 if the energy still decreases at a step length
/// of 1.
/// \param rows of `problem`.
/// \param direction the displacement at a step length of 1 (padded).
/// \param rates the strain increment of each link due to `direction`.
/// \param coupled true to let friction limits follow their normal forces along the direction; on return, the limits
/// are those for the last step length tried. If false, the limits stay fixed.
double lineSearch(StepProblem& problem, const LinkRows& rows, const Trial& from, const Eigen::VectorXd& direction,
                  const std::vector<double>& rates, bool coupled);

/// The same, with limits that follow, for a direction along which the resistance decreases at first. Step lengths may
/// reach a few thousand; empty if the energy still decreases there.
std::optional<double> longLineSearch(StepProblem& problem, const LinkRows& rows, const Trial& from,
                                     const Eigen::VectorXd& direction, const std::vector<double>& rates);

}  // namespace keyblock
