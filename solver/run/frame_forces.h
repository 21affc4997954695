// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a frame keeps of the forces that the engine lists. What follows from its
// contacts, blocks and nodes is left out, so that a run store grows little.
#pragma once

#include "solver/engine/stage/acting_forces.h"

namespace keyblock {

/// \param frame made of `state`. \param moves the forces are those of a step in motion; contacts at its end have others.
FrameForces frameForces(const std::vector<SingleForce>& forces, const State& state, const Frame& frame, bool moves);

}  // namespace keyblock
