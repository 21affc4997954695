// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene without its bolts: the forces that they had in a run act as dead loads
// in their place. So a factor of safety can leave out what bolts would take up as
// the rock moves.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

/// Where the blocks are when a static stage begins, and all forces on them when it ends.
struct StageFrames {
    Frame first, last;
};

/// The scene without bolts and patterns, and without what names them (installation, removal, monitors, quantities and
/// expected numbers). The force of every anchored point and face plate on a block becomes a load at that point of the
/// block; a stage changes the loads of the stage before into its own in proportion to pseudo-time, the first stage and one
/// that sets strengths at its start.
/// Blocks that are held as a whole get none. \param run frames of every stage of `scene`.
/// \pre the scene was checked without errors and all its stages are static and ended in equilibrium.
Scene withFrozenBolts(const Scene& scene, const std::vector<StageFrames>& run);

}  // namespace keyblock
