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

/// Blocks of the scene that the stage takes out, by index; names that nothing has are left out.
std::vector<int> excavatedBlocks(const Scene& scene, const Stage& stage);

/// Index of the bolt of that name; −1 when there is none.
int boltNamed(const Scene& scene, const std::string& name);

/// True where some stage installs the bolt: it is not there before.
bool isInstalledLater(const Scene& scene, const Bolt& bolt);

/// Stress in situ at a place of the scene [Pa]; zero where the scene has none.
Stress inSituStressAt(const Scene& scene, const Point& place);

}  // namespace keyblock
