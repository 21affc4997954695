// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene with errors cannot be run, but a user who opens one in a window
// wants to see what there is of it and to put it right.
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
    std::optional<Scene> scene;  // as far as it could be read; none when the text is not a scene at all
    std::vector<std::string> leftOut;  // pointers to objects that lack something they need, and to what is not a field
    bool brokeOff = false;  // the text is not JSON from some line on; the scene is what precedes it
    bool isWhole = false;  // the scene says all that the text says, so that it may be written over it
    std::vector<Problem> problems;  // of single fields; whether the scene is meaningful is not checked
};

/// Reads what can be read. Values that cannot be read keep their defaults; an object without one that it needs is left
/// out. Records are looked for from `folder`.
SceneRescue rescueSceneText(std::string_view text, const std::string& name,
                            const std::filesystem::path& folder = {});

}  // namespace keyblock
