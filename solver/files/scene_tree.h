// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The step from tree to scene, for those who read a scene whatever is wrong with
// it. Nothing here asks whether the scene makes sense.
#pragma once

#include "solver/files/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// The scene of a tree of the newest version. What cannot be read keeps its default and is a problem; records are looked
/// for from `folder`.
Scene sceneOfTree(const JsonNode& root, const std::filesystem::path& folder, std::vector<Problem>& problems);

/// The row of the place in the table of fields; null where it is not a field but an item of a list or map, or nothing.
const Field* sceneFieldAt(const std::string& pointer);

}  // namespace keyblock
