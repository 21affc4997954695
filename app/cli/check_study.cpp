// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/check_study.h"

#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "solver/scene/visible_text.h"
#include "solver/study/case_plan.h"
#include "solver/study/study_file.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

std::string countOf(long count, std::string_view what) {
    return std::to_string(count) + " " + std::string(what) + (count == 1 ? "" : "s");
}

long severityCount(const std::vector<Problem>& problems, Severity severity) {
    return std::ranges::count(problems, severity, &Problem::severity);
}

}  // namespace

ExitCode checkStudyFile(const CheckOptions& options) {
    if (!options.overrides.empty()) throw UsageError("--set changes a scene; change the values of a study in its file");
    const StudyReading reading = readStudyFile(options.scene);
    const std::vector<Problem>& problems = reading.problems;
    const std::optional<long> cases = reading.study ? std::optional(CasePlan(*reading.study).cases()) : std::nullopt;
    if (options.json) {
        print(studyCheckJson(problems, cases));
        return hasErrors(problems) ? Invalid : Done;
    }
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error) printToError(oneLine(problem) + '\n');
        else print(oneLine(problem) + '\n');
    print(visibleText(options.scene.string()) + ": " + countOf(severityCount(problems, Severity::Error), "error") +
          ", " + countOf(severityCount(problems, Severity::Warning), "warning") + ", " +
          countOf(severityCount(problems, Severity::Note), "note") + "\n");
    if (reading.study)
        print(countOf(*cases, "case") + " of " +
              countOf(static_cast<long>(reading.study->parameters.size()), "parameter") + " and " +
              countOf(static_cast<long>(reading.study->faults.size()), "fault") + "\n");
    return hasErrors(problems) ? Invalid : Done;
}

}  // namespace keyblock::cli
