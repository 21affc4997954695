// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The version of the scene format rises with every incompatible change. Older
// scenes are brought up to date on the JSON tree, one version after another,
// before anything else looks at them.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/problem.h"

#include <vector>

namespace keyblock {

inline constexpr int sceneVersion = 1;

/// Brings the tree to `sceneVersion`. False when it is not a scene, or of a version that this program does not know:
/// `problems` then say so, and nothing else in it can be judged. A missing key counts as the newest.
bool bringUpToDate(JsonNode& root, std::vector<Problem>& problems);

}  // namespace keyblock
