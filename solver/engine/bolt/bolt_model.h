// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine's model of a bolt: its mesh, its steel, the law of each anchored point, and
// its face plate.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// Model of bolt `index` of the scene.
/// \pre `model` already contains its blocks, and `model.nodes` is the total number of nodes of the preceding bolts.
BoltModel boltModel(const Scene& scene, int index, const Model& model);

}  // namespace keyblock
