// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The step from tree to scene, for reading a scene regardless of what is wrong with
// it. Whether the scene is meaningful is not checked here.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/scene/field.h"
#include "solver/scene/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// The scene of a tree of the newest version. What cannot be read keeps its default and is reported in `unread`; what
/// leads nowhere, a type of bolt or a record's file, is in the scene as it is written and is reported in `lost`.
/// Records are looked for from `folder`.
Scene sceneOfTree(const JsonNode& root, const std::filesystem::path& folder, std::vector<Problem>& unread,
                  std::vector<Problem>& lost);

/// The row of the place in the table of fields; null where it is not a field but an item of a list or map, or nothing.
const Field* sceneFieldAt(const std::string& pointer);

}  // namespace keyblock
