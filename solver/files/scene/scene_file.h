// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and writes scenes as JSON. Reading reports all errors at once: syntax, keys,
// types, ranges and consistency of the scene.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"
#include "solver/scene/scene_cut.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct SceneReading {
    std::optional<Scene> scene;  // present if no problem is an error
    std::optional<SceneCut> cut;  // result of cutting, if the scene needs cutting and can be cut
    std::vector<Problem> problems;  // sorted by line, including warnings and notes
};

/// Folder to which paths of record files are relative; empty: the current folder. None: no files are read, and a scene
/// that names one is refused.
using RecordFolder = std::optional<std::filesystem::path>;

/// Reads and checks a scene file. If the file cannot be opened, this is reported as a problem.
/// \param overrides strings of the form `path=value`, applied before the scene is read and checked. The path is written
///        as `stages[0].increments`, as `stages/0/increments` or as a JSON pointer. The value is JSON or, if it is not
///        valid JSON, plain text.
SceneReading readSceneFile(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// Reads and checks a scene given as text.
/// \param name the file name for messages.
/// \param overrides as in `readSceneFile`.
/// \param folder the folder of record files; none for a scene that contains its records, as in a run store.
SceneReading readSceneText(std::string_view text, const std::string& name, std::span<const std::string> overrides = {},
                           const RecordFolder& folder = std::filesystem::path());

/// The scene as JSON text with all required keys and all keys whose values differ from their defaults, in the order in
/// which the format lists them. Numbers have as few digits as are needed to read them back exactly. Built-in bolt types
/// and records stored in files are left out.
std::string sceneText(const Scene& scene);

/// The scene as JSON text, as from `sceneText`, but with all records included, so that reading it gives the same scene
/// in any folder.
std::string wholeSceneText(const Scene& scene);

/// SHA-256 of `wholeSceneText` in hexadecimal digits: scenes with the same hash are equal, including their records.
std::string sceneHash(const Scene& scene);

/// Writes the scene atomically. A reference to a record file is kept if it still refers to the same record from the new
/// location; otherwise the record is included in the scene file.
/// \throws CannotWrite
void writeSceneFile(const std::filesystem::path& path, const Scene& scene);

}  // namespace keyblock
