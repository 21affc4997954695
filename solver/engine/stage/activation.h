// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks and bolts that come and go between two steps. What goes takes the energy
// that it stores with it; what rested on it is told as forces on those that stay,
// for the run to hold and let go (theory, "Excavation").
#pragma once

#include "solver/engine/model/loads.h"

#include <vector>

namespace keyblock {

/// Takes a bolt that a later stage installs out of a state where nothing has moved yet.
void leaveOut(const Model& model, State& state, int bolt);

/// Takes out blocks and cells by rows of the model.
/// \return what they gave to blocks and bolts that stay, by the forces last accepted.
std::vector<WallForce> excavate(const Model& model, State& state, const std::vector<int>& rows);

/// Puts a bolt into the rock as it is now, straight and unstressed, bonded where it lies. Its ends are where the rock
/// has carried them; its length is that of the scene.
void installBolt(const Model& model, State& state, int bolt);

/// Takes a bolt away with all that it stores; its plate, too.
void removeBolt(const Model& model, State& state, int bolt);

}  // namespace keyblock
