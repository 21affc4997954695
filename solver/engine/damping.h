// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rayleigh damping of a step: a force a·M·v on every body, and b times the
// elastic stiffness against the rate of strain of blocks, of the glue between
// their cells and of bolts' shanks. Springs of contacts, supports and anchors
// have none: what they lose is friction, and a viscous part would exceed the limits
// that they obey.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Work of the damping of bodies over the step `d` [J]; that of shanks and glue is a law's.
double dampedWork(const Model& model, const State& state, const StepOptions& options, const Eigen::VectorXd& d);

/// Damping of a dynamic step in its matrices, loads and links. It damps the links of the carriers before it.
extern const Carrier dampingCarrier;

}  // namespace keyblock
