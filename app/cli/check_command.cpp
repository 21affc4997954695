// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `check`: lists all problems of a scene, the blocks into which its domain
// is cut, what will be modelled, what could be left out next, and how long a run will
// take. A study is checked with its scene.
#include "app/cli/check_study.h"
#include "app/cli/cli_commands.h"
#include "app/cli/json_answers.h"
#include "app/cli/model_summary_listing.h"
#include "app/cli/output.h"
#include "app/cli/preset_listing.h"
#include "solver/files/scene/scene_file.h"
#include "solver/scene/number_text.h"
#include "solver/scene/visible_text.h"
#include "solver/study/study_file.h"
#include "solver/trade/trade_next.h"

#include <algorithm>
#include <optional>

namespace keyblock::cli {

namespace {

std::string counted(const std::vector<Problem>& problems, Severity severity) {
    const auto count = std::count_if(problems.begin(), problems.end(),
                                     [&](const Problem& problem) { return problem.severity == severity; });
    return std::to_string(count) + " " + std::string(wordOf(severity)) + (count == 1 ? "" : "s");
}

/// Prints errors to standard error and everything else to standard output.
void tellErrors(const std::filesystem::path& scene, const std::vector<Problem>& problems) {
    for (const Problem& problem : problems)
        if (problem.severity == Severity::Error)
            printToError(oneLine(problem) + '\n');
        else
            print(oneLine(problem) + '\n');
    print(visibleText(scene.string()) + ": " + counted(problems, Severity::Error) + ", " +
          counted(problems, Severity::Warning) + ", " + counted(problems, Severity::Note) + "\n");
}

constexpr std::size_t mostOfAKind = 10;

std::string placeText(const Point& place) { return "(" + coordinateText(place.x()) + ", " + coordinateText(place.y()) + ")"; }

/// Prints what was merged, trimmed and dropped: the number of each kind, then up to ten of them, or all.
void tellNotes(const SceneCut& cut, bool all) {
    for (auto note = cut.notes.begin(); note != cut.notes.end();) {
        const auto end = std::find_if(note, cut.notes.end(), [&](const CutNote& n) { return n.kind != note->kind; });
        const std::size_t count = end - note;
        print("  " + std::string(wordOf(note->kind)) + ": " + std::to_string(count) + '\n');
        const std::size_t listed = all ? count : std::min(count, mostOfAKind);
        for (std::size_t i = 0; i < listed; ++i, ++note)
            print("    at " + placeText(note->place) + ": " + visibleText(noteText(cut, *note)) + '\n');
        if (listed < count)
            print("    and " + std::to_string(count - listed) + " more; --all lists them\n");
        note = end;
    }
}

void tellCut(const SceneCut& cut, bool all) {
    if (cut.blocks == 0 && cut.sources.empty())
        return;  // only bolt patterns were laid out; there was nothing to cut
    print("cut into " + std::to_string(cut.blocks) + " blocks of " + rounded(cut.area) + " m² with " +
          std::to_string(cut.vertices) + " corners; tolerance " + lengthText(cut.tolerance) + ", minimum area " +
          areaText(cut.minArea) + ", minimum width " + lengthText(cut.minWidth) + '\n');
    if (cut.open > 0)
        print("  omitted in tunnels that are open from the start: " + std::to_string(cut.open) + '\n');
    if (cut.split > 0)
        print("  cuts through intact rock next to openings: " + std::to_string(cut.split) + '\n');
    tellNotes(cut, all);
}

/// The model summary of a scene that has no errors and at least one block.
std::optional<ModelSummary> modelSummaryOf(const std::filesystem::path& file, const SceneReading& reading) {
    const SceneCut* cut = reading.cut ? &*reading.cut : nullptr;
    if (!reading.scene || (cut ? cut->scene : *reading.scene).blocks.empty())
        return std::nullopt;
    std::optional<ModelSummary> summary = makeModelSummary(cut ? cut->scene : *reading.scene, cut);
    if (const auto trade = findStoredTrade(file, *reading.scene))
        summary->next = withMeasured(std::move(summary->next), *reading.scene, trade->points, trade->quantities);
    return summary;
}

}  // namespace

ExitCode perform(const CheckOptions& options) {
    if (isStudyFile(options.scene)) return checkStudyFile(options);
    const SceneReading reading = readSceneFile(options.scene, options.overrides);
    const std::optional<ModelSummary> summary = modelSummaryOf(options.scene, reading);
    if (options.json) {
        print(checkJson(reading, summary, options.overrides));
        return hasErrors(reading.problems) ? Invalid : Done;
    }
    tellErrors(options.scene, reading.problems);
    if (reading.cut)
        tellCut(*reading.cut, options.all);
    if (reading.scene) print(presetLines(reading.cut ? reading.cut->scene : *reading.scene, options.overrides));
    if (summary)
        print(modelSummaryLines(*summary));
    return hasErrors(reading.problems) ? Invalid : Done;
}

}  // namespace keyblock::cli
