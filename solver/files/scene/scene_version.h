// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The version number of the scene format increases with every incompatible change.
// Older scenes are upgraded in the JSON tree, one version at a time, before they are
// read.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"

#include <vector>

namespace keyblock {

inline constexpr int sceneVersion = 1;

/// Upgrades the tree to `sceneVersion`. A tree without a version key is assumed to have the newest version.
/// \return false if the tree is not a scene or has an unknown version; this is then reported in `problems`, and the
///         tree cannot be checked further.
bool bringUpToDate(JsonNode& root, std::vector<Problem>& problems);

}  // namespace keyblock
