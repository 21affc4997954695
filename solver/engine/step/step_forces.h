// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strains and forces of a step at a given displacement, with the friction limits as
// they are, and the forces and noise that residuals are compared with.
#pragma once

#include "solver/engine/step/trial.h"

#include <vector>

namespace keyblock {

/// Strain of every link at displacement `d`.
void linkStrains(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& strains);

/// Net force on every unknown at `d` (external less internal), prescribed ones included: there it is minus the reaction.
Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d);

/// Forces of the contacts over the step on every unknown, as they act on the bodies.
Eigen::VectorXd contactForce(const StepProblem& problem, const Eigen::VectorXd& d);

/// Largest of the summed forces by kind: what residuals are compared with [N].
double referenceForce(const StepProblem& problem, const Eigen::VectorXd& d, const Eigen::VectorXd& net);

/// Norm of the residual of the free unknowns [N], and the body with most of it.
double residualNorm(const StepProblem& problem, const Eigen::VectorXd& net);

/// The same of one body [N].
double bodyResidual(const StepProblem& problem, const Eigen::VectorXd& net, int body);

/// Force that appears where every place is off by `length` [N].
double placeNoise(const StepProblem& problem, double length);

}  // namespace keyblock
