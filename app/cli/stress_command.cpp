// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `stress`: pushes a scene along its settings, prints a line for every push,
// then what breaks first and what to set.
#include "app/cli/cli_commands.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/runnable_scene.h"
#include "app/cli/stop_signals.h"
#include "app/cli/text_table.h"
#include "solver/run/run.h"
#include "solver/trade/change_text.h"
#include "solver/trade/stress.h"

#include <cmath>

namespace keyblock::cli {

namespace {

const std::vector<TextColumn> pushColumns{{"push", Align::Left, 34},
                                          {"ending", Align::Left, 8},
                                          {"change", Align::Right, 17},
                                          {"time, s", Align::Right, 9},
                                          {""}};

void printPush(const StressPoint& point) {
    std::string change;
    if (!point.quantity.empty()) change = std::isfinite(point.moved) ? changeText(point.moved) : "no value";
    std::string text = point.reason.empty() ? point.quantity : point.reason;
    for (const std::string& warning : point.warnings) text += "; warning: " + warning;
    print(textLine(pushColumns, {point.push.axis + " " + point.push.text, std::string(wordOf(point.ending)), change,
                                 shownSeconds(point.seconds), text}));
}

}  // namespace

ExitCode perform(const StressOptions& options) {
    const std::optional<SceneReading> read = runnableScene(options.scene, options.overrides);
    if (!read) return Invalid;
    Control control;
    const StopSignals signals(control.stop);
    StressTest stress;
    StressSettings settings;
    if (!options.json) {
        print(textLine(pushColumns, {"push", "ending", "change", "time, s", "quantity or reason"}));
        settings.measured = printPush;
    }
    settings.run = [&](const Scene& changed, const SceneCut& cut, const std::string& label, Sink& sink) {
        ProgressSink progress(cut.scene, sink, chosenProgress(options.progress), label + ", ");
        control.progress = [&](const Progress& now) { progress.update(now); };
        keyblock::run(changed, progress, control, {1, &cut});
    };
    const bool whole = measureStress(*read->scene, settings, stress);
    if (options.json) print(stressJson(stress));
    if (!whole) {
        printErrorLine("interrupted; the pushes above are complete");
        return Interrupted;
    }
    if (!stress.own.failure.empty()) {
        printErrorLine("the scene has no result as given to compare with: " + stress.own.failure);
        return NumericalFailure;
    }
    if (!options.json) print("\n" + stressAnswer(stress));
    return Done;
}

}  // namespace keyblock::cli
