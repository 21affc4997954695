// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `sweep run`: all that a job scheduler calls. It prints a line for each
// case that it finishes.
#include "app/start/blas_choice.h"
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/stop_signals.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/build_id.h"
#include "solver/scene/suggest.h"
#include "solver/scene/visible_text.h"
#include "solver/study/case_run.h"

#include <charconv>
#include <cstdlib>
#include <optional>

namespace keyblock::cli {

namespace {

namespace fs = std::filesystem;

std::optional<long> positiveNumber(std::string_view text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 1) return std::nullopt;
    return number;
}

CaseRange rangeOf(const std::string& text) {
    const auto dash = text.find('-');
    const std::optional<long> first = positiveNumber(std::string_view(text).substr(0, dash));
    const std::optional<long> last = dash == std::string::npos
                                         ? first
                                         : positiveNumber(std::string_view(text).substr(dash + 1));
    if (!first || !last || *last < *first)
        throw UsageError("--index: " + inQuotes(text) + " is not of the form N or N-M, counted from 1");
    return {*first, *last};
}

/// The cases that are asked for: by --index, or those of the task of a job array.
CaseRange chosenCases(const SweepRunOptions& options, const SweepPlan& plan) {
    if (options.index) {
        const CaseRange range = rangeOf(*options.index);
        if (range.last > plan.cases)
            throw UsageError("--index: the sweep has only " + std::to_string(plan.cases) + " cases");
        return range;
    }
    const char* variable = std::getenv("SLURM_ARRAY_TASK_ID");
    if (!variable)
        throw UsageError(
            "give the cases with --index N or N-M, or run this as a task of a job array "
            "(SLURM_ARRAY_TASK_ID)");
    const std::optional<long> task = positiveNumber(variable);
    if (!task || *task > plan.tasks())
        throw UsageError("SLURM_ARRAY_TASK_ID is " + inQuotes(variable) + ", but the sweep has the tasks 1 to " +
                         std::to_string(plan.tasks()));
    return casesOfTask(plan, *task);
}

bool isFinished(const fs::path& sweep, long number) {
    std::error_code error;
    return fs::exists(summaryPath(sweep, number), error);
}

void printCase(const SweepCaseResult& result) {
    std::string line = "case " + std::to_string(result.number) + ": " + std::string(wordOf(result.outcome));
    if (result.fails) line += *result.fails ? ", fails" : ", does not fail";
    if (!result.reason.empty()) line += "; " + visibleText(result.reason);
    print(line + "\n");
}

void requireSameBuild(const SweepRunOptions& options, const SweepPlan& plan) {
    if (plan.build != buildId())
        throw CannotRead("cannot run " + options.sweep.string() +
                         ": another build of the program planned it, whose results may differ; use that build, or "
                         "plan the sweep again");
}

/// Runs the cases of a range that are not finished. \return the first one that another process runs; 0: none.
long runCases(const SweepRun& run, const CaseRange& range, Control& control) {
    long busy = 0;
    for (long number = range.first; number <= range.last && !control.stop; ++number) {
        if (isFinished(run.sweep.folder, number)) continue;
        SweepCaseResult result;
        const CaseEnd end = runCase(run, number, control, result);
        if (end == CaseEnd::Done) printCase(result);
        if (end == CaseEnd::Busy && busy == 0) busy = number;
        if (end == CaseEnd::Interrupted) break;
    }
    return busy;
}

}  // namespace

ExitCode perform(const SweepRunOptions& options) {
    const SweepPlan plan = readSweepPlan(options.sweep);
    const CaseRange range = chosenCases(options, plan);
    long first = range.first;
    while (first <= range.last && isFinished(options.sweep, first)) ++first;
    if (first > range.last) return Done;
    requireSameBuild(options, plan);
    useBlasKernel(plan.kernel);
    const Sweep sweep = openSweep(options.sweep);
    const SweepRun run = sweepRunOf(sweep, options.threads);
    Control control;
    const StopSignals signals(control.stop, RepeatedTerm::Ignored);
    const long busy = runCases(run, {first, range.last}, control);
    if (control.stop) {
        printErrorLine("interrupted; run the same command again to continue");
        return Interrupted;
    }
    if (busy > 0 && !isFinished(options.sweep, busy)) {
        printErrorLine("case " + std::to_string(busy) +
                       " is being run by another process; run the same command again "
                       "when that has ended");
        return Interrupted;
    }
    return Done;
}

}  // namespace keyblock::cli
