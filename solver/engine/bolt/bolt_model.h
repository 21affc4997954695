// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine's model of a bolt: its mesh, its steel, the law of each anchored point, and
// its face plate.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// Model of bolt `index` of the scene.
/// \pre `model` already contains its blocks, and its `nodes` is the number of nodes of the previous bolts.
BoltModel boltModel(const Scene& scene, int index, const Model& model);

}  // namespace keyblock
