// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Active blocks and bolts of each stage. Stages name the blocks that they excavate and
// the bolts that they install or remove; the check and the run both use these
// functions to resolve the names.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Indices of the scene's blocks that the stage excavates, in increasing order: the blocks named in `stage.excavate`
/// and all blocks in tunnels named there. Unknown names are ignored.
/// \pre the scene has been cut.
std::vector<int> excavatedBlocks(const Scene& scene, const Stage& stage);

/// Indices of the scene's bolts, in increasing order, that have this name or belong to the pattern with this name.
/// \pre the scene has been cut.
std::vector<int> boltsNamed(const Scene& scene, const std::string& name);

/// True if a stage installs the bolt, by its own name or by that of its pattern, so that the bolt is not present from
/// the start.
bool isInstalledLater(const Scene& scene, const Bolt& bolt);

/// In-situ stress [Pa] at a point of the scene; zero if the scene has none.
Stress inSituStressAt(const Scene& scene, const Point& place);

}  // namespace keyblock
