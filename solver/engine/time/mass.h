// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Masses and motion of all bodies as vectors over the unknowns of a step: six for
// each block, then three for each node of a bolt.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

struct StepProblem;

/// Velocity and acceleration of every unknown as the state has them; zero where it has no accelerations.
Eigen::VectorXd velocitiesOf(const Model& model, const State& state);
Eigen::VectorXd accelerationsOf(const Model& model, const State& state);

/// Mass and rotational inertia of a node of a bolt, in the model's thickness [kg, kg, kg·m²].
Eigen::Vector3d nodeMass(const BoltModel& bolt, std::size_t node);

/// M⁻¹·force of every body, over the unknowns that `problem` leaves free; zero where there is no mass.
Eigen::VectorXd byMass(const Model& model, const StepProblem& problem, const Eigen::VectorXd& force);

/// M·x for every body.
Eigen::VectorXd timesMass(const Model& model, const Eigen::VectorXd& x);

/// Kinetic energy of blocks and bolts [J].
double kineticEnergy(const Model& model, const State& state);

}  // namespace keyblock
