// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sides of the model that let waves out: dashpots of the rock's own impedance
// replace the supports of the side, whose forces stay (theory, "Viscous boundaries").
#pragma once

#include "solver/engine/carrier/carrier.h"

#include <vector>

namespace keyblock {

/// Two dashpots a face on the sides of the domain, or of the box round all blocks where there is none: density · wave
/// speed · area, of pressure waves across the side and of shear waves along it.
std::vector<Dashpot> dashpotsOn(const Model& model, const State& state, const std::vector<BoundarySide>& sides);

/// Rows of the point supports on the sides, where their blocks are present.
std::vector<std::size_t> supportsOn(const Model& model, const State& state, const std::vector<BoundarySide>& sides);

/// Links of the dashpots of a step in motion.
extern const Carrier boundaryCarrier;

}  // namespace keyblock
