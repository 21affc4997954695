// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `run`: reads the scene, runs it into the store, reads the store back and
// prints a summary. What is printed at the end has therefore been written to disk.
#include "app/cli/cli_commands.h"
#include "app/cli/estimate_listing.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/summary_text.h"
#include "app/cli/stop_signals.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/resumption.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/run_store/stored_estimate.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/verdict.h"
#include "solver/results/result_names.h"
#include "solver/run/checkpoint_check.h"
#include "solver/run/run.h"
#include "solver/trade/error_estimate.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

namespace fs = std::filesystem;

/// The scene if it can be run. Errors are printed on standard error, but warnings with the results: standard error is
/// for progress, which other programs read line by line.
std::optional<SceneReading> runnableScene(const RunOptions& options) {
    SceneReading reading = readSceneFile(options.scene, options.overrides);
    for (const Problem& problem : reading.problems)
        if (problem.severity == Severity::Error)
            printToError(oneLine(problem) + '\n');
        else if (problem.severity == Severity::Warning)
            print(oneLine(problem) + '\n');
    if (reading.scene && reading.scene->stages.empty()) {
        printErrorLine(options.scene.string() + ": /stages: the scene has no stages, so there is nothing to run; " +
                       "add one, or check it with 'keyblock check'");
        return std::nullopt;
    }
    if (!reading.scene)
        return std::nullopt;
    return reading;
}

bool anyEnded(const std::vector<StageResult>& results, Outcome outcome) {
    return std::any_of(results.begin(), results.end(),
                       [&](const StageResult& result) { return result.outcome == outcome; });
}

ExitCode exitCodeOf(const std::vector<StageResult>& results) {
    if (anyEnded(results, Outcome::Failed))
        return NumericalFailure;
    if (anyEnded(results, Outcome::Stopped))
        return Interrupted;
    const bool limited = anyEnded(results, Outcome::Limit) || anyEnded(results, Outcome::Undecided);
    return limited ? LimitReached : Done;
}

bool stands(const RunSource& run) {
    return verdictOf(run.stages(), run.scene()).stands.value_or(true);
}

void tellWhyItEnded(ExitCode code, const Scene& scene, const std::vector<StageResult>& results, const fs::path& out) {
    const std::string kept = "; results so far are in " + out.string();
    if (code == Interrupted)
        printErrorLine("interrupted" + kept + "; run again with --resume to continue");
    if (code == LimitReached)
        printErrorLine("a limit was reached" + kept);
    if (code != NumericalFailure)
        return;
    for (const StageResult& result : results)
        if (result.outcome == Outcome::Failed)
            printErrorLine("stage '" + stageName(scene, result.stage) + "': " + result.message + kept);
}

/// Prints the summary of a store. \return whether the scene is stable.
bool tellResults(const fs::path& out, const std::map<int, double>& stageSeconds) {
    const RunStore run(out);
    print(summaryOf(run, stageSeconds) + "\nresults in " + out.string() + "\n");
    return stands(run);
}

/// Runs the scene into its store, from the checkpoint if there is one. Returns the result of each stage.
std::vector<StageResult> runInto(RunStoreWriter& store, const SceneReading& read, const RunOptions& options,
                                 const std::optional<Checkpoint>& from, std::map<int, double>& stageSeconds) {
    const Scene& scene = *read.scene;
    ProgressSink sink(read.cut ? read.cut->scene : scene, store, chosenProgress(options.progress));
    Control control;
    control.progress = [&](const Progress& progress) { sink.update(progress); };
    const StopSignals signals(control.stop);
    const Checkpoint* start = from ? &*from : nullptr;
    const std::vector<StageResult> results = keyblock::run(scene, sink, control,
                                                           {options.threads, read.cut ? &*read.cut : nullptr}, start);
    store.close();
    stageSeconds = sink.stageSeconds();
    return results;
}

/// The results of a finished run that quantities are read from, with the last frame only.
Results lastResults(const RunStore& run) {
    Results results{run.columns(), run.history(), run.events(), {}, {}};
    if (!run.frames().empty()) results.frames.push_back(run.frame(run.frames().size() - 1));
    for (const StageRecord& record : run.stages())
        if (record.ended) results.stages.push_back(record.result);
    return results;
}

/// Runs the scene again with finer settings; prints and stores the estimated errors.
ExitCode estimateInto(const fs::path& out, const Scene& scene, const RunOptions& options) {
    Control control;
    const StopSignals signals(control.stop);
    const auto runFine = [&](const Scene& fine, const SceneCut& cut, const std::string& label, Sink& sink) {
        ProgressSink progress(cut.scene, sink, chosenProgress(options.progress), label + ", ");
        control.progress = [&](const Progress& now) { progress.update(now); };
        keyblock::run(fine, progress, control, {options.threads, &cut});
    };
    const std::optional<ErrorEstimate> estimate = estimateErrors(scene, lastResults(RunStore(out)), runFine);
    if (!estimate) {
        printErrorLine("interrupted; the errors are not estimated; run again with --resume to estimate them");
        return Interrupted;
    }
    storeEstimate(out, *estimate);
    print(errorEstimateLines(*estimate));
    return Done;
}

}  // namespace

ExitCode perform(const RunOptions& options) {
    fs::path out = options.out.value_or(fs::path(options.scene).replace_extension(".kbrun"));
    const std::optional<SceneReading> read = runnableScene(options);
    if (!read)
        return Invalid;
    const std::optional<Scene>& scene = read->scene;
    const Resumption resumption = options.resume ? resumptionOf(out, *scene) : Resumption{};
    std::map<int, double> stageSeconds;
    std::vector<StageResult> results;
    if (!resumption.finished) {
        RunStoreWriter store(out, options.overwrite || options.resume);
        try {
            results = runInto(store, *read, options, resumption.checkpoint, stageSeconds);
        } catch (const UnfitCheckpoint& error) {
            throw CannotRead("cannot resume " + out.string() + ": " + error.what() + " with --overwrite");
        }
    }
    const bool isStable = tellResults(out, stageSeconds);
    const ExitCode code = exitCodeOf(results);
    tellWhyItEnded(code, *scene, results, out);
    if (code == Done && options.estimateError)
        if (const ExitCode estimated = estimateInto(out, *scene, options); estimated != Done) return estimated;
    return code == Done && options.failOnCollapse && !isStable ? DoesNotStand : code;
}

}  // namespace keyblock::cli
