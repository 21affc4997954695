// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Initial contact forces and block stresses of a dynamic stage. Without them the loads
// would act suddenly on touching blocks that carry no force yet and make them bounce
// (theory, "The start of a motion").
#pragma once

#include "solver/engine/stage/engine.h"

namespace keyblock {

/// If any touching contact carries no force yet, finds forces consistent with the initial loads and stores them as
/// preload; nothing moves. These are the forces of static equilibrium, which is sought first with friction locked, then
/// with the friction limits applied. If there is no equilibrium, the forces of the first time step from rest are used.
/// \param first the loads at the start. \param timeStep the maximum time step of the stage [s].
/// \return false if the run was stopped in the meantime; `state` is then unchanged.
bool takePreload(Engine& engine, State& state, const Loads& loads, const LoadPoint& first, double timeStep);

}  // namespace keyblock
