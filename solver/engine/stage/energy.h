// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Energies of a state: what is stored, what moves, and the balance over all that
// was accounted for since the start.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Elastic energy held by the links and blocks where they are [J], by kind.
StoredEnergy storedEnergy(const Model& model, const State& state);

/// Kinetic energy of a block, and what its stress stores [J].
double energyOfBlock(const Model& model, int row, const BlockMotion& motion);

/// All energies with their balance.
Energy energyOf(const Model& model, const State& state);

/// Everything stored, moving and used, less the work of the loads [J]: constant where the energies balance.
double accountedEnergy(const Energy& e);
double accountedEnergy(const Model& model, const State& state);

/// Largest term so far, with which errors of the balance are compared [J].
double largestEnergy(const Model& model, const State& state, const Energy& e);

}  // namespace keyblock
