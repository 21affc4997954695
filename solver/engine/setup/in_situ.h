// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In-situ stress: rock that is stressed before anything is done to it. Blocks have
// the stress at their centroids; contacts, glue and point supports start with what it
// gives to their faces, so that where it is in equilibrium nothing moves
// (theory, "In-situ stress").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Forces that point supports give where nothing has moved: those of the scene's stress on faces that no other block
/// touches. Changes nothing in a scene without.
void preloadSupports(const Scene& scene, Model& model);

/// Contacts and glue of the start carry what the scene's stress gives to their faces. Changes nothing in a scene without.
/// \pre `contacts` were found as the first ones.
void preloadFaces(const Scene& scene, const Model& model, State& state);

}  // namespace keyblock
