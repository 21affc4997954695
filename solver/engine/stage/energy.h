// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energies of a state: elastic and kinetic energy, and the energy balance since the
// start of the run.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Elastic energy stored in links and blocks at the current positions of the bodies, by kind [J].
StoredEnergy storedEnergy(const Model& model, const State& state);

/// Kinetic plus strain energy of a block [J].
/// \param row the index of the block in `Model::blocks`.
double energyOfBlock(const Model& model, int row, const BlockMotion& motion);

/// All energies [J] and the relative error of the energy balance.
Energy energyOf(const Model& model, const State& state);

/// Stored, kinetic and dissipated energy minus the work of the loads [J]; constant if the energy balance is satisfied.
double accountedEnergy(const Energy& e);
double accountedEnergy(const Model& model, const State& state);

/// Energy to which errors of the energy balance are related [J]: the largest energy term, or an energy at the level of
/// round-off if that is larger.
double largestEnergy(const Model& model, const State& state, const Energy& e);

}  // namespace keyblock
