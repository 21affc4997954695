// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ends a dynamic stage whose energy balance error is too large.
#pragma once

#include "solver/engine/model/state.h"

#include <optional>

namespace keyblock {

/// Reference values for the energy check; plain values, part of the checkpoint.
struct EnergyMark {
    double left = 0.0;  // energy-balance error at the start of the stage [J]
    double largest = 0.0;  // largest energy found by the checks of this run so far [J]
};

/// Energy-balance error of a stage that exceeds the limit set in the scene.
struct EnergyExcess {
    double share = 0.0;  // error divided by the largest term of the energy balance
    int block = -1;  // block that has gained most energy since the start of the stage; −1: none has
};

/// Called at the start of a stage. Stores the energy-balance error at that time in `mark.left` and updates
/// `mark.largest`.
void markEnergy(const Model& model, const State& state, EnergyMark& mark);

/// The energy-balance error since the start of the stage; none if it does not exceed the limit. An error is ignored as
/// numerical noise if it is below 1e-3 of the largest energy of the run, or below 1e-9·E·V·ε². E and V are the Young's
/// modulus and volume of the block with the largest E·V, and ε is a strain of 1e-4.
/// \param start the blocks at the start of the stage.
/// \param allowed the limit, as a fraction of the largest term of the energy balance.
/// \param mark the reference values; `mark.largest` is updated.
std::optional<EnergyExcess> energyExcess(const Model& model, const State& state, const std::vector<BlockMotion>& start,
                                         double allowed, EnergyMark& mark);

}  // namespace keyblock
