// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `trade`: prints a line for every run, then one sentence on the settings
// that it recommends. An interrupted trade continues in the same folder.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/progress.h"
#include "app/cli/runnable_scene.h"
#include "app/cli/stop_signals.h"
#include "app/cli/text_table.h"
#include "app/cli/trade_chart.h"
#include "solver/run/run.h"
#include "solver/trade/change_text.h"
#include "solver/trade/trade.h"
#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_folder.h"
#include "solver/trade/trade_page.h"

#include <cmath>

namespace keyblock::cli {

namespace {

const std::vector<TextColumn> pointColumns{
    {"settings", Align::Left, 44}, {"time, s", Align::Right, 9}, {"work", Align::Right, 9}, {""}};

void printPoint(const TradePoint& point) {
    print(textLine(pointColumns,
                   {nameOf(point), shownSeconds(point.seconds), threeDigits(workOf(point.work)), point.failure}));
}

void printLeftOut(const Trade& trade) {
    for (const TradeLeftOut& left : trade.leftOut)
        print("not run: " + left.axis + " " + left.setting + ", which " + left.reason + "\n");
}

std::string answer(const Trade& trade) {
    const int best = recommendedPoint(trade, recommendedError);
    const std::string most = changeText(recommendedError);
    if (best < 0) return "no settings are recommended: " + withoutRecommendation(trade, recommendedError) + "\n";
    std::string text = "recommended, within " + most + " of the finest run:\n" + sentenceOn(trade, best) + "\n";
    for (const std::string& set : trade.points[best].overrides) text += "  --set " + set + "\n";
    if (const int preset = recommendedPreset(trade, recommendedError); preset >= 0 && preset != best)
        text += "recommended preset:\n" + sentenceOn(trade, preset) + "\n";
    return text;
}

}  // namespace

ExitCode perform(const TradeOptions& options) {
    const std::optional<SceneReading> read = runnableScene(options.scene, options.overrides);
    if (!read) return Invalid;
    const Scene& scene = *read->scene;
    TradeFolder folder(options.out, scene);
    if (folder.knownPoints() > 0)
        print(std::to_string(folder.knownPoints()) + " runs of this trade are in " + options.out.string() +
              " already\n");
    print(textLine(pointColumns, {"settings", "time, s", "work", ""}));
    Control control;
    const StopSignals signals(control.stop);
    Trade trade;
    trade.quantities = folder.quantities();
    TradeSettings settings;
    settings.budget = options.budget;
    settings.known = [&](const TradeSetting& setting) {
        std::optional<TradePoint> point = folder.known(setting);
        if (point) printPoint(*point);
        return point;
    };
    settings.measured = [&](const TradePoint& point) {
        folder.keep(point, trade.quantities);
        printPoint(point);
    };
    settings.run = [&](const Scene& changed, const SceneCut& cut, int threads, const std::string& label, Sink& sink) {
        ProgressSink progress(cut.scene, sink, chosenProgress(options.progress), label + ", ");
        control.progress = [&](const Progress& now) { progress.update(now); };
        keyblock::run(changed, progress, control, {threads, &cut});
    };
    const bool whole = measureTrade(scene, settings, trade);
    if (trade.points.empty()) {
        printErrorLine("interrupted before the first run ended");
        return Interrupted;
    }
    folder.writeTables(trade, scene);
    writeTradeChart(trade, scene, options.out);
    printLeftOut(trade);
    if (!whole) {
        printErrorLine("interrupted; run again with the same --out to continue");
        return Interrupted;
    }
    if (const std::string& failure = trade.points.front().failure; !failure.empty()) {
        printErrorLine("the scene has no result with its own settings to compare with: " + failure);
        return NumericalFailure;
    }
    print("\n" + answer(trade) + "\ntrade.csv and trade.md are in " + options.out.string() + "\n");
    return Done;
}

}  // namespace keyblock::cli
