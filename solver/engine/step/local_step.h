// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of a step that concerns a few bodies while all others stay where they are at
// a trial displacement. A loose block among stressed rock often keeps Newton's method
// from full steps, because its contacts open and close one after the other; with its
// neighbours held, its position is found in a problem of a few unknowns.
#pragma once

#include "solver/engine/step/link_rows.h"
#include "solver/engine/step/step_problem.h"

#include <vector>

namespace keyblock {

/// A step of the bodies `bodies` alone.
struct LocalStep {
    StepProblem problem;
    std::vector<int> bodies;  // in the whole step, ascending; body i of `problem` is `bodies[i]`

    /// The bodies' displacements, taken from those of the whole step.
    Eigen::VectorXd taken(const StepProblem& whole, const Eigen::VectorXd& d) const;

    /// Inserts the bodies' displacements `own` into those of the whole step.
    void insert(const StepProblem& whole, const Eigen::VectorXd& own, Eigen::VectorXd& d) const;
};

/// Adds all bodies within `rings` links of the bodies `bodies`. Driven bodies are left out, and nothing is reached through
/// them.
/// \param rows the links of `whole`.
/// \return in ascending order.
std::vector<int> withNeighbours(const StepProblem& whole, const LinkRows& rows, const std::vector<int>& bodies,
                                int rings);

/// \param rows the links of `whole`.
/// \param bodies in ascending order.
/// \param d displacements at which the other bodies are held, one entry for each unknown of the whole step at least.
LocalStep localStep(const StepProblem& whole, const LinkRows& rows, std::vector<int> bodies, const Eigen::VectorXd& d);

}  // namespace keyblock
