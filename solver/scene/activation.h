// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is there in which stage. Blocks go and bolts come and go at the start of
// a stage, by name; this follows the names, in one way for check and run.
#pragma once

#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Blocks of the scene that the stage takes out, by index: those that it names, and those in tunnels that it names.
/// Names that nothing has are left out. \pre the scene is cut.
std::vector<int> excavatedBlocks(const Scene& scene, const Stage& stage);

/// Bolts of that name or of the pattern of that name, by rising index. \pre the scene is cut.
std::vector<int> boltsNamed(const Scene& scene, const std::string& name);

/// True where some stage installs the bolt, by its own name or that of its pattern: it is not there before.
bool isInstalledLater(const Scene& scene, const Bolt& bolt);

/// Stress in situ at a place of the scene [Pa]; zero where the scene has none.
Stress inSituStressAt(const Scene& scene, const Point& place);

}  // namespace keyblock
