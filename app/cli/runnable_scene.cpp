// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/runnable_scene.h"

#include "app/cli/output.h"

namespace keyblock::cli {

std::optional<SceneReading> runnableScene(const std::filesystem::path& path, std::span<const std::string> overrides) {
    SceneReading reading = readSceneFile(path, overrides);
    for (const Problem& problem : reading.problems)
        if (problem.severity == Severity::Error) printToError(oneLine(problem) + '\n');
    if (!reading.scene) return std::nullopt;
    if (reading.scene->stages.empty()) {
        printErrorLine(path.string() + ": /stages: the scene has no stages, so there is nothing to run");
        return std::nullopt;
    }
    return reading;
}

}  // namespace keyblock::cli
