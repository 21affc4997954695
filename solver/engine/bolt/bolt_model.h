// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt of the scene as the engine sees it: its mesh, its steel, the law of each
// anchored point and its plate.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// \pre the model has its blocks, and `nodes` counts those of the bolts before this one
BoltModel boltModel(const Scene& scene, int index, const Model& model);

}  // namespace keyblock
