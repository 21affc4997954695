// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Viscous boundaries, which absorb outgoing waves: dashpots with the impedance of the
// rock replace the supports on a side of the model, while the support forces are kept as
// loads (theory, "Viscous boundaries").
#pragma once

#include "solver/engine/carrier/carrier.h"

#include <vector>

namespace keyblock {

/// Dashpots on the given sides of the domain, or of the bounding box of all blocks if there is no domain. Each face has
/// two dashpots, each for half of the face. The coefficients of a dashpot are density · wave speed · area, with the
/// speed of pressure waves normal to the side and of shear waves along it.
std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const std::vector<BoundarySide>& sides);

/// Indices into Model::supports of the point supports that lie on the given sides and whose blocks are present.
std::vector<std::size_t> supportsOn(const Model& model, const State& state, const std::vector<BoundarySide>& sides);

/// Force carrier of the dashpots, which act in dynamic steps only.
extern const Carrier boundaryCarrier;

}  // namespace keyblock
