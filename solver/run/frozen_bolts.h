// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene whose bolts are replaced by dead loads: the forces that the bolts had in a
// run. A factor of safety computed with it excludes the additional forces that bolts
// would mobilise as the rock moves.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// First and last frame of a static stage. They give the block positions at the start of the stage and all forces on
/// the blocks at its end.
struct StageFrames {
    Frame first, last;
};

/// The scene without bolts and bolt patterns, and without all references to them (installation, removal, monitors,
/// quantities and expected values). The force of every anchored point and face plate on a block becomes a load at that
/// point of the block. In each stage, these loads change linearly with pseudo-time from their values in the previous
/// stage to their values in this stage. In the first stage, and in any stage that changes strengths, they act in full
/// from the start. Blocks that are fixed as a whole get no loads.
/// \param run the first and last frame of every stage of `scene`, indexed by stage.
/// \pre `checkScene(scene)` found no error, and all stages are static and ended in equilibrium in `run`.
Scene withFrozenBolts(const Scene& scene, const std::vector<StageFrames>& run);

}  // namespace keyblock
