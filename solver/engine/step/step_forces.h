// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strains and forces of a step at a given displacement with the current friction
// limits, and the reference forces and round-off with which residuals are compared.
#pragma once

#include "solver/engine/step/trial.h"

#include <vector>

namespace keyblock {

/// Strain of a link, and of every link, at displacement `d`.
double linkStrain(const StepProblem& problem, const Link& link, const Eigen::VectorXd& d);
void linkStrains(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& strains);

/// Net force (external minus internal) on every unknown at displacement `d`. For a prescribed unknown it is the
/// negative of the reaction.
Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d);

/// The same if the strains at `d` are known already. \param strains as returned by `linkStrains`.
Eigen::VectorXd netForce(const StepProblem& problem, const Eigen::VectorXd& d, const std::vector<double>& strains);

/// Generalised contact forces on every unknown over the step, before multiplication by the weight that the time scheme
/// gives to contact forces.
Eigen::VectorXd contactForce(const StepProblem& problem, const Eigen::VectorXd& d);

/// Reference force for residuals [N]: the magnitudes are summed separately for each kind of force (loads, reactions,
/// contacts, bolts), and the largest sum is returned.
/// \param net the net force at displacement `d`, as returned by `netForce`.
double referenceForce(const StepProblem& problem, const Eigen::VectorXd& d, const Eigen::VectorXd& net);

/// Norm of the net force over the free unknowns of all bodies [N].
double residualNorm(const StepProblem& problem, const Eigen::VectorXd& net);

/// Norm of the net force over the free unknowns of one body [N].
double bodyResidual(const StepProblem& problem, const Eigen::VectorXd& net, int body);

/// Force error [N] caused by an error of `length` [m] in all positions.
double placeNoise(const StepProblem& problem, double length);

}  // namespace keyblock
