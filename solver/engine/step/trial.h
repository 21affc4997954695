// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step at one trial displacement: strains of the links, what their laws give
// there, and what the bodies are left with.
#pragma once

#include "solver/engine/step/link_rows.h"

#include <vector>

namespace keyblock {

/// Vectors over the unknowns are padded (`LinkRows`).
struct Trial {
    Eigen::VectorXd d;
    std::vector<double> strains;  // of the links at `d`
    std::vector<LawResponse> laws;  // force and tangent of every link there, before its share
    Eigen::VectorXd net;  // external less internal force on every unknown
};

/// Judges displacement `d` (padded): the friction limits are set to what the forces there allow.
Trial trialAt(StepProblem& problem, const LinkRows& rows, Eigen::VectorXd d);

/// Moves a trial on by `length` times the direction whose strain rates are known, and judges it there.
void advance(StepProblem& problem, const LinkRows& rows, const Eigen::VectorXd& direction,
             const std::vector<double>& rates, double length, Trial& trial);

/// Inertia and elasticity of the bodies times `x`; both padded.
Eigen::VectorXd bodyProduct(const StepProblem& problem, const Eigen::VectorXd& x);

}  // namespace keyblock
