// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Partial reading of a scene with errors. Such a scene cannot be run, but a user who
// opens it in the window wants to see what can be read and to correct the rest.
#pragma once

#include "solver/scene/problem.h"
#include "solver/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct SceneRescue {
    std::optional<Scene> scene;  // as far as it could be read; none if the text is not a scene at all
    std::vector<std::string> leftOut;  // pointers to objects without a required value, and to values that are no fields
    bool brokeOff = false;  // the text is invalid JSON from some point on; the scene is what precedes it
    bool isWhole = false;  // the scene contains all data of the text, so saving it loses nothing
    std::vector<Problem> problems;  // errors of single fields; the consistency of the scene is not checked
};

/// Reads as much of a scene as possible. Values that cannot be read keep their defaults; objects without a valid value
/// for a required field are left out.
/// \param name the file name for messages.
/// \param folder the folder to which paths of record files are relative.
SceneRescue rescueSceneText(std::string_view text, const std::string& name,
                            const std::filesystem::path& folder = {});

}  // namespace keyblock
