// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rayleigh damping of a step: a force a·M·v on every body, and b times the elastic
// stiffness times the strain rate of blocks, of the glue between their cells, and of
// bolt shanks. The springs of contacts, supports and anchors are not damped: their only
// dissipation is friction, and a viscous force would add to their limited forces.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Energy dissipated by the damping of bodies over the displacement `d` of a step [J]. The damping of shanks and glue
/// is accounted for by the laws of their links.
double dampedWork(const Model& model, const State& state, const StepOptions& options, const Eigen::VectorXd& d);

/// Force carrier of the damping. It adds damping to the matrices and loads of the bodies in a dynamic step, and a
/// viscous link for each damped link that the preceding carriers have added.
extern const Carrier dampingCarrier;

}  // namespace keyblock
