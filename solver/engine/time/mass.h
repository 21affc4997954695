// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Masses and motion of all bodies as vectors over the unknowns of a step: six for each
// block, then three for each bolt node.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct StepProblem;

/// Velocities and accelerations of all unknowns; the accelerations are zero if the state has none.
Eigen::VectorXd velocitiesOf(const Model& model, const State& state);
Eigen::VectorXd accelerationsOf(const Model& model, const State& state);

/// Diagonal of the mass matrix of a bolt node: mass for x and y [kg] and rotational inertia [kg m²], for all bolts in
/// the thickness of the model.
Eigen::Vector3d nodeMass(const BoltModel& bolt, std::size_t node);

/// Accelerations M⁻¹·force of the unknowns that are free in `problem`; zero for prescribed unknowns and for unknowns
/// without mass.
Eigen::VectorXd byMass(const Model& model, const StepProblem& problem, const Eigen::VectorXd& force);

/// Product M·x of the mass matrix of all bodies and `x`.
Eigen::VectorXd timesMass(const Model& model, const Eigen::VectorXd& x);

/// Kinetic energy of blocks and bolts [J].
double kineticEnergy(const Model& model, const State& state);

}  // namespace keyblock
