// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads and writes study files, and reads the scene that a study names. All problems of
// both are reported at once, as for a scene.
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
    std::optional<Study> partly;  // as far as it can be read, with or without errors; none if the text is not JSON
    bool isWhole = false;  // every value of the text is in `partly`
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

/// Reads and checks a study given as text.
/// \param path of its file, to whose folder the path of the scene is relative; the file need not exist.
/// \param scene text of the scene if it differs from its file; null: it is read from the file.
StudyReading readStudyText(std::string text, const std::filesystem::path& path, const std::string* scene = nullptr);

/// The study as JSON text with all required keys and all keys whose values differ from their defaults. Values that do
/// not apply, for example the mean of a uniform distribution, are left out.
std::string studyText(const Study& study);

/// Writes a study file atomically. \throws CannotWrite
void writeStudyFile(const std::filesystem::path& path, const Study& study);

/// Reads a study that has been checked before. \throws CannotRead if it has errors. \param name for messages.
Study readCheckedStudy(std::string_view text, const std::string& name);

}  // namespace keyblock
