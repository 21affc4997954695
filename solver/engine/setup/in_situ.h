// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In-situ stress, the initial stress in the rock. Each block has the stress at its
// centroid. Contacts, glue and point supports start with the forces due to the stress on
// their faces, so that nothing moves if the stress field is in equilibrium (theory,
// "In-situ stress").
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Sets the preload of each point support: the force at zero displacement due to the in-situ stress on those faces of
/// the block that end at the support and touch no other block. Does nothing in a scene without in-situ stress.
void preloadSupports(const Scene& scene, Model& model);

/// Sets the initial forces of contacts and glue due to the in-situ stress on their faces. Does nothing in a scene
/// without in-situ stress.
/// \pre the contacts in `state` were found with the blocks at their initial positions.
void preloadFaces(const Scene& scene, const Model& model, State& state);

}  // namespace keyblock
