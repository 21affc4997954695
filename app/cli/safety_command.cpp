// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `safety`: prints a line for every run as it finishes, then the bracket
// and how the scene fails. It is a result and not an error if the scene fails at every
// factor, or at none.
#include "app/cli/cli_commands.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/safety_folder.h"
#include "app/cli/stop_signals.h"
#include "app/cli/text_table.h"
#include "solver/files/json/json_tree.h"
#include "solver/files/scene/overrides.h"
#include "solver/files/scene/scene_file.h"
#include "solver/results/result_names.h"
#include "solver/run/safety.h"
#include "solver/run/strength_reduction.h"
#include "solver/scene/solved_blocks.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/visible_text.h"

#include <fstream>
#include <iterator>

namespace keyblock::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostMoving = 10;  // blocks or joints listed; --json lists all
const std::vector<TextColumn> runColumns{
    {"factor", Align::Right, 9}, {"", Align::Left, 10}, {"stage", Align::Left, 16}, {"outcome", Align::Left, 11},
    {"steps", Align::Right, 7}};

/// Adds the file and line to the problems found by `checkSafety`.
void placeIn(std::vector<Problem>& problems, const SafetyOptions& options) {
    std::ifstream file(options.scene, std::ios::binary);
    JsonReading json = readJson(std::string(std::istreambuf_iterator<char>(file), {}));
    std::vector<Problem> ignored;
    if (json.root)
        applyOverrides(*json.root, options.overrides, ignored);
    for (Problem& problem : problems)
        problem.line = json.root ? lineAt(*json.root, problem.pointer) : 0;
    nameOrigins(problems, options.scene.string(), options.overrides);
}

/// The scene if a factor of safety can be computed for it. Otherwise prints the reasons on standard error.
std::optional<SceneReading> askedScene(const SafetyOptions& options) {
    SceneReading reading = readSceneFile(options.scene, options.overrides);
    std::vector<Problem> problems = reading.problems;
    if (reading.scene) {
        problems = checkSafety(*reading.scene);
        placeIn(problems, options);
    }
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            printToError(oneLine(problem) + '\n');
    if (hasErrors(problems))
        return std::nullopt;
    return reading;
}

template <typename Choice>
std::string word(Choice choice) {
    return std::string(wordsOf(choice)[static_cast<std::size_t>(choice)]);
}

TextRow runRow(const Scene& scene, const SafetyRun& run) {
    return {shown(run.factor), run.end.outcome == Outcome::Undecided ? "" : run.stands ? "stable" : "fails",
            stageName(scene, run.end.stage),
            std::string(wordOf(run.end.outcome)), std::to_string(run.end.steps)};
}

fs::path folderOf(const SafetyOptions& options) {
    if (options.out)
        return *options.out;
    return options.scene.parent_path() / (options.scene.stem().string() + "-safety");
}

SafetyFactor search(const Scene& scene, const SafetyOptions& options, SafetyFolder& folder, Control& control) {
    const StopSignals signals(control.stop);
    const auto trial = [&](const Scene& reduced, double factor, Sink& sink) {
        folder.record(sink, [&](Sink& both) {
            ProgressSink progress(reduced, both, chosenProgress(options.progress), "factor " + shown(factor) + ", ");
            control.progress = [&](const Progress& now) { progress.update(now); };
            keyblock::run(reduced, progress, control, {options.threads, nullptr});
        });
    };
    const auto report = [&](const SafetyRun& run) {
        folder.keep(run);
        if (!options.json)
            print(textLine(runColumns, runRow(scene, run)));
    };
    return findSafetyFactor(scene, trial, report);
}

std::string answerLine(const SafetyFactor& found) {
    if (found.nothingToFreeze)
        return "the scene fails with its own strengths, so there are no bolt forces in equilibrium to freeze and no "
               "factor of safety; set safety.bolt_forces to mobilised to find a factor below 1\n";
    if (found.lower && found.upper)
        return "factor of safety between " + shown(*found.lower) + " (stable) and " + shown(*found.upper) +
               " (fails)\n";
    if (found.lower && *found.lower >= mostSafety)
        return "stable even at a factor of " + shown(*found.lower) +
               ": the stability of this scene does not depend on what is reduced\n";
    if (found.upper && *found.upper <= leastSafety)
        return "fails even at a factor of " + shown(*found.upper) +
               ": raising the reduced strengths cannot stabilise it\n";
    if (found.lower)
        return "factor of safety above " + shown(*found.lower) + " (stable)\n";
    return found.upper ? "factor of safety below " + shown(*found.upper) + " (fails)\n" : "";
}

std::string movingBlocks(const std::vector<std::string>& names, const FailureMode& mode) {
    std::vector<TextRow> rows;
    for (const MovingBlock& block : mode.blocks)
        if (rows.size() < mostMoving)
            rows.push_back({blockName(names, block.block), std::string(wordOf(block.movement)),
                            shown(block.displacement.x()), shown(block.displacement.y()), shown(block.rotation)});
    return textTable({{"largest movement"},
                      {""},
                      {"ux, m", Align::Right},
                      {"uy, m", Align::Right},
                      {"rotation, rad", Align::Right}},
                     rows);
}

std::string movingJoints(const std::vector<std::string>& names, const FailureMode& mode) {
    std::vector<TextRow> rows;
    for (const MovingJoint& joint : mode.joints)
        if (rows.size() < mostMoving)
            rows.push_back({blockName(names, joint.blockA) + " on " + blockName(names, joint.blockB),
                            shown(joint.position.x()), shown(joint.position.y()), shown(joint.slip),
                            shown(joint.opening)});
    return rows.empty() ? "" : "\n" + textTable({{"joint between"},
                                                 {"x, m", Align::Right},
                                                 {"y, m", Align::Right},
                                                 {"slip, m", Align::Right},
                                                 {"opening, m", Align::Right}},
                                                rows);
}

/// The message of the failing run at the upper end of the bracket, and what moved.
std::string modeText(const Scene& solved, const SafetyFactor& found) {
    std::string text;
    for (const SafetyRun& run : found.runs)
        if (run.factor == found.upper)
            text = "\nat " + shown(run.factor) + ", stage '" + visibleText(stageName(solved, run.end.stage)) +
                   "': " + std::string(wordOf(run.end.outcome)) + "; " + visibleText(run.end.message) + "\n";
    if (!found.mode || found.mode->blocks.empty())
        return text;
    const std::vector<std::string> names = blockNames(solved);
    return text + "\n" + movingBlocks(names, *found.mode) + movingJoints(names, *found.mode);
}

ExitCode exitCodeOf(const SafetyFactor& found) {
    if (!found.cutShort)
        return Done;
    return *found.cutShort == Outcome::Stopped ? Interrupted : LimitReached;
}

}  // namespace

ExitCode perform(const SafetyOptions& options) {
    const std::optional<SceneReading> read = askedScene(options);
    if (!read)
        return Invalid;
    const Scene& scene = *read->scene;
    const Scene& solved = read->cut ? read->cut->scene : scene;
    SafetyFolder folder(folderOf(options), options.overwrite);
    if (!options.json)
        print("reduced: " + word(scene.safety.reduce) +
              (scene.safety.boltForces == BoltForces::Frozen ? "\nbolt forces: frozen at their values at a factor of 1"
                                                             : "") +
              "\n\n" + textLine(runColumns, {"factor", "", "stage", "outcome", "steps"}));
    Control control;
    const SafetyFactor found = search(scene, options, folder, control);
    folder.finish(solved);
    print(options.json ? safetyJson(solved, found)
                       : "\n" + answerLine(found) + modeText(solved, found) + "\nruns in " + folderOf(options).string() + "\n");
    const ExitCode code = exitCodeOf(found);
    if (code == Interrupted)
        printErrorLine("interrupted; the bracket found so far is printed");
    if (code == LimitReached)
        printErrorLine(*found.cutShort == Outcome::Undecided
                           ? "the runs next to the bracket are undecided; raise 'limits.iterations' to continue"
                           : "a limit of the scene was reached in one of the runs; raise 'limits' to continue");
    return code;
}

}  // namespace keyblock::cli
