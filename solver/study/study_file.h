// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads a study file and the scene that it names. All problems of both are reported at
// once, as for a scene.
#pragma once

#include "solver/files/scene/scene_file.h"
#include "solver/scene/problem.h"
#include "solver/study/study.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct StudyReading {
    std::optional<Study> study;  // present if no problem is an error
    std::optional<SceneReading> scene;  // the scene with its own values, if the study names one that can be read
    std::string text;  // of the study file
    std::string sceneText;  // of the scene file, with its records inside
    std::vector<Problem> problems;  // of the study first, then of the scene
};

/// Whether a JSON text says that it is a study. Texts that are not JSON are not.
bool isStudyText(std::string_view text);

/// Whether the file is a study. False for what is not a regular file.
bool isStudyFile(const std::filesystem::path& path);

/// Reads and checks a study file and its scene. If the file cannot be opened, this is reported as a problem.
StudyReading readStudyFile(const std::filesystem::path& path);

/// Reads a study that has been checked before. \throws CannotRead if it has errors. \param name for messages.
Study readCheckedStudy(std::string_view text, const std::string& name);

}  // namespace keyblock
