// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step evaluated at a trial displacement: strains of the links, responses of their
// laws, and net forces on the bodies.
#pragma once

#include "solver/engine/step/link_rows.h"

#include <vector>

namespace keyblock {

/// Strains and forces at a trial displacement. Vectors with one entry per unknown are padded (see `LinkRows`).
struct Trial {
    Eigen::VectorXd d;  // displacement
    std::vector<double> strains;  // per link, at `d`
    std::vector<LawResponse> laws;  // force and tangent per link at `d`, not multiplied by `Law::share`
    Eigen::VectorXd net;  // external minus internal force on every unknown
};

/// Evaluates the step at displacement `d` (padded) and sets the friction limits to match the forces there.
Trial trialAt(StepProblem& problem, const LinkRows& rows, Eigen::VectorXd d);

/// Evaluates the step at the displacement of the trial `from` plus `length` times `direction`.
/// \param rates the strain increment of each link due to `direction`.
/// \param to receives the result; its memory is used again.
void advance(StepProblem& problem, const LinkRows& rows, const Trial& from, const Eigen::VectorXd& direction,
             const std::vector<double>& rates, double length, Trial& to);

/// Product of the bodies' stiffness (inertia and elasticity) and `x`; `x` and the result are padded.
Eigen::VectorXd bodyProduct(const StepProblem& problem, const Eigen::VectorXd& x);

}  // namespace keyblock
