// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a frame keeps of the forces that the engine lists: what its contacts, blocks
// and nodes already say is left to them, so that a run store grows by little.
#pragma once

#include "solver/engine/stage/block_forces.h"

namespace keyblock {

/// \param frame made of `state`. \param moves the forces are those of a step in motion, which contacts at its end do not tell.
FrameForces frameForces(const std::vector<SingleForce>& forces, const State& state, const Frame& frame, bool moves);

}  // namespace keyblock
