// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Activation and deactivation of parts of the model between two steps: excavation of
// rock, installation and removal of bolts, and release of supports by a viscous
// boundary. The energy stored in a deactivated part is accounted for as released. The
// forces that excavated rock and released supports exerted on the remaining parts are
// returned, so that the run can hold them at first and relax them later (theory,
// "Excavation").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// Deactivates a bolt that is installed in a later stage, together with its plate.
/// \pre nothing has moved yet in `state`.
void leaveOut(const Model& model, State& state, int bolt);

/// Excavates blocks and cells.
/// \param rows the indices of the blocks and cells in `Model::blocks`.
/// \return the last accepted forces that the excavated rock exerted on the remaining blocks and bolts.
std::vector<WallForce> excavate(const Model& model, State& state, const std::vector<int>& rows);

/// Installs a bolt. It is straight, unstressed and bonded to the blocks that it crosses. It lies on the line through
/// the current positions of its borehole's ends and has the length given in the scene.
void installBolt(const Model& model, State& state, int bolt);

/// Removes a bolt and its plate; their stored energy is accounted for as released.
void removeBolt(const Model& model, State& state, int bolt);

/// Releases the point supports on the given sides of the model.
/// \return the forces that they exerted, to be kept as loads.
std::vector<WallForce> releaseSupports(const Model& model, State& state, const std::vector<BoundarySide>& sides);

/// Reactivates the released supports at their current positions, with the forces that they carried at release.
void restoreAllSupports(const Model& model, State& state);

}  // namespace keyblock
