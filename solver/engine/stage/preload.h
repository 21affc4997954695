// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact forces and block stresses that a dynamic stage starts from. Touching
// blocks that carry no force yet would otherwise be hit by the loads all at once and
// bounce (theory, "The start of a motion").
#pragma once

#include "solver/engine/stage/engine.h"

namespace keyblock {

/// Finds forces that agree with the loads at the start, `first`, where touching contacts carry none yet, and keeps them as
/// preload; nothing moves. They are those of rest, found with friction locked and then under its limits; in a scene that
/// finds no rest, those of its first step from rest.
/// \param timeStep of the stage [s].
/// \return false where the run was stopped meanwhile; `state` is then as it was.
bool takePreload(Engine& engine, State& state, const Loads& loads, const LoadPoint& first, double timeStep);

}  // namespace keyblock
