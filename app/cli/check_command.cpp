// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The verb `check`: everything that is wrong with a scene, nothing run.
#include "app/cli/commands.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "solver/files/scene_file.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

std::string counted(const std::vector<Problem>& problems, Severity severity) {
    const auto count = std::count_if(problems.begin(), problems.end(),
                                     [&](const Problem& problem) { return problem.severity == severity; });
    return std::to_string(count) + " " + std::string(wordOf(severity)) + (count == 1 ? "" : "s");
}

/// Errors to standard error, the rest of the answer to standard output.
void tell(const std::filesystem::path& scene, const std::vector<Problem>& problems) {
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            printToError(oneLine(problem) + '\n');
        else
            print(oneLine(problem) + '\n');
    print(scene.string() + ": " + counted(problems, Severity::Error) + ", " +
          counted(problems, Severity::Warning) + ", " + counted(problems, Severity::Note) + "\n");
}

}  // namespace

ExitCode perform(const CheckOptions& options) {
    const SceneReading reading = readSceneFile(options.scene, options.overrides);
    if (options.json)
        print(problemsJson(reading.problems));
    else
        tell(options.scene, reading.problems);
    return hasErrors(reading.problems) ? Invalid : Done;
}

}  // namespace keyblock::cli
