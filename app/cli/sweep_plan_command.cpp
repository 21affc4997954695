// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `sweep plan`.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "solver/study/study_file.h"
#include "solver/study/sweep_folder.h"

#include <system_error>

namespace keyblock::cli {

namespace {

/// Path of this program for scripts; its name where the system does not tell.
std::string programPath() {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
    return error ? "keyblock" : path.string();
}

}  // namespace

ExitCode perform(const SweepPlanOptions& options) {
    const StudyReading read = readStudyFile(options.study);
    for (const Problem& problem : read.problems)
        if (problem.severity == Severity::Error) printToError(oneLine(problem) + '\n');
        else if (problem.severity == Severity::Warning) print(oneLine(problem) + '\n');
    if (!read.study) return Invalid;
    const SweepPlan plan = planSweep(options.out, read, programPath());
    const std::string folder = options.out.string();
    print(std::to_string(plan.cases) + " cases in " + folder + "\nrun them with 'keyblock sweep run " + folder +
          " --index 1-" + std::to_string(plan.cases) + "', " + folder +
          "/run-parallel.sh or 'sbatch submit.sbatch' there\n");
    return Done;
}

}  // namespace keyblock::cli
