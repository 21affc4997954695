// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ends a dynamic stage whose energy balance error is too large.
#pragma once

#include "solver/engine/model/state.h"

#include <optional>

namespace keyblock {

/// What the limit compares with; plain values, part of the checkpoint.
struct EnergyMark {
    double left = 0.0;  // what the balance left over when the stage began [J]
    double largest = 0.0;  // largest energy of the run so far, as far as it was looked at [J]
};

/// What a stage has left over, where that is more than the scene allows.
struct EnergyExcess {
    double share = 0.0;  // over the largest term of the balance
    int block = -1;  // that gained most energy since the stage began
};

/// Takes the balance where a stage begins.
void markEnergy(const Model& model, const State& state, EnergyMark& mark);

/// Compares what the stage has left over since with `allowed`, a share of the largest term. What is less than 1e-3 of
/// the largest energy of the run, or than a strain of 1e-4 stores in 1e-9 of a block, is noise.
/// \param start blocks as they were when the stage began.
std::optional<EnergyExcess> energyExcess(const Model& model, const State& state, const std::vector<BlockMotion>& start,
                                         double allowed, EnergyMark& mark);

}  // namespace keyblock
