// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parts of the model that are activated or deactivated between two steps: rock that
// is excavated, bolts that are installed or removed, supports that a viscous boundary
// releases. What goes takes the energy that it stores with it; the forces that it gave
// to what stays are returned, for the run to hold and to release (theory, "Excavation").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/scene/scene.h"

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

/// Releases the point supports on the sides. \return the forces that they gave, to be kept.
std::vector<WallForce> releaseSupports(const Model& model, State& state, const std::vector<BoundarySide>& sides);

/// Released supports carry force again, where they are and the force that they gave.
void restoreAllSupports(const Model& model, State& state);

}  // namespace keyblock
