// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Conversion of a JSON tree to a scene. Errors do not stop it: everything that can be
// read is converted. The consistency of the scene is not checked here.
#pragma once

#include "solver/files/json/json_tree.h"
#include "solver/files/scene/scene_file.h"
#include "solver/scene/field.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

/// Converts a JSON tree of the newest format version to a scene.
/// \param folder as in `readSceneText`.
/// \param unread receives an error for each value that cannot be read; such values keep their defaults.
/// \param lost receives an error for each reference to a missing bolt type or record file; the scene keeps the
///        references.
Scene sceneOfTree(const JsonNode& root, const RecordFolder& folder, std::vector<Problem>& unread,
                  std::vector<Problem>& lost);

/// The field to which a JSON pointer leads; null if it leads to an item of a list or map, or to no known field.
const Field* sceneFieldAt(const std::string& pointer);

}  // namespace keyblock
