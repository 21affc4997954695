// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scenes from and to JSON. Reading reports all errors at once:
// syntax, keys, types, ranges, and whether the scene makes sense.
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
    std::optional<Scene> scene;  // there when no problem is an error
    std::optional<SceneCut> cut;  // what it was cut to, if it needs that and can be
    std::vector<Problem> problems;  // by line; warnings and notes too
};

/// Reads and checks a scene file. A file that cannot be opened is a problem too.
/// `overrides` are `path=value` texts: the path as `stages[0].increments`, `stages/0/increments` or a JSON pointer,
/// the value JSON or a bare text. They are set before anything is read, so every check sees them.
SceneReading readSceneFile(const std::filesystem::path& path, std::span<const std::string> overrides = {});

/// The same from a text; `name` is used in place of the file's name, records are looked for from `folder` (empty: the
/// current one).
SceneReading readSceneText(std::string_view text, const std::string& name,
                           std::span<const std::string> overrides = {}, const std::filesystem::path& folder = {});

/// The scene as a JSON text: required keys and those that differ from their default, in the order of the format,
/// numbers as short as they can be read back exactly. Built-in bolt types are left out, and records that have a file.
std::string sceneText(const Scene& scene);

/// The same with all records inside: it is read back to the same scene wherever it is.
std::string wholeSceneText(const Scene& scene);

/// SHA-256 of `wholeSceneText`, in hexadecimal digits: two scenes with the same hash say the same, records included.
std::string sceneHash(const Scene& scene);

/// Writes the scene whole or not at all; a record stays in its file where that says the same seen from there, and comes
/// along where it does not. \throws CannotWrite
void writeSceneFile(const std::filesystem::path& path, const Scene& scene);

}  // namespace keyblock
