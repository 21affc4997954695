// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A deviation from an expected value is printed but does not affect the exit code,
// because the run itself succeeded.
#include "app/cli/summary_text.h"

#include "app/cli/bolt_summary.h"
#include "app/cli/text_table.h"
#include "app/cli/verdict_text.h"
#include "solver/results/event_groups.h"
#include "solver/results/quantity.h"
#include "solver/results/result_names.h"
#include "solver/scene/number_text.h"
#include "solver/scene/preset.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <cmath>

namespace keyblock::cli {

namespace {

constexpr std::size_t mostInOrder = 6;  // events of `order KIND` that are listed

std::string stageTable(const Scene& scene, const std::vector<StageRecord>& records,
                       const std::map<int, double>& seconds) {
    std::vector<TextColumn> columns{
        {"stage"}, {"kind"}, {"outcome"}, {"time", Align::Right}, {"steps", Align::Right}};
    if (!seconds.empty())
        columns.push_back({"seconds", Align::Right});
    std::vector<TextRow> rows;
    for (const StageRecord& record : records) {
        const StageResult& result = record.result;
        rows.push_back({stageName(scene, result.stage),
                        std::string(wordOf(scene.stages[result.stage].kind)),
                        record.ended ? std::string(wordOf(result.outcome)) : "not ended",
                        record.ended ? shown(result.time) : "", record.ended ? std::to_string(result.steps) : ""});
        if (!seconds.empty())
            rows.back().push_back(seconds.contains(result.stage) ? shownSeconds(seconds.at(result.stage)) : "");
    }
    return textTable(columns, rows);
}

std::string messages(const Scene& scene, const std::vector<StageRecord>& records) {
    std::string text;
    for (const StageRecord& record : records)
        if (!record.result.message.empty())
            text += visibleText(stageName(scene, record.result.stage) + ": " + record.result.message) + "\n";
    return text;
}

std::string eventLine(const std::vector<Event>& events) {
    const std::string text = EventCounts(events).text();
    return "events  " + (text.empty() ? "none" : text) + "\n";
}

std::string sleepText(const std::optional<double>& awake) {
    return !awake || *awake == 1.0 ? "" : ", " + rounded(100.0 * *awake) + " % of the blocks awake in dynamic steps";
}

std::string healthLine(const std::vector<StageRecord>& records) {
    const std::optional<RunHealth> health = healthOf(records);
    if (!health)
        return {};
    return "solver  " + rounded(health->passesMean) + " iterations per step, " + std::to_string(health->stepCuts) +
           " step reductions, " + std::to_string(health->energyCuts) + " reductions for energy, deepest penetration " +
           rounded(health->maxPenetrationRatio) + " of a block, residual " + rounded(health->residual) +
           ", energy balance error " + rounded(health->balanceError) + sleepText(health->awakeMean) + "\n";
}

std::string measuredText(const Measurement& measurement) {
    return measurement.value ? shown(*measurement.value) : "–";
}

std::string quantityTable(const RecordedRun& run) {
    std::vector<TextRow> rows;
    for (const std::string& text : run.scene.quantities) {
        const Measurement measurement = measure(text, run);
        const std::string remark = measurement.order.empty() ? measurement.problem
                                                             : orderText(measurement.order, mostInOrder);
        rows.push_back({text, measuredText(measurement), remark});
    }
    return rows.empty() ? "" : "\n" + textTable({{"quantity"}, {"value (SI)", Align::Right}, {""}}, rows);
}

/// Whether no stage was cut short. Only then can results be compared with expected values.
bool isWhole(const std::vector<StageRecord>& records) {
    return std::all_of(records.begin(), records.end(), [](const StageRecord& record) {
        const Outcome outcome = record.result.outcome;
        return record.ended && (endedAsPlanned(outcome) || endedUnstable(outcome));
    });
}

std::string verdictOf(const MeasuredComparison& comparison, bool whole) {
    if (!whole)
        return "incomplete";
    return comparison.within ? "met" : "missed";
}

TextRow expectedRow(const MeasuredComparison& comparison, bool whole) {
    const Expected& expected = comparison.expected;
    const bool relative = expected.value != 0.0;
    const bool known = comparison.measured.value.has_value();
    const std::string deviation = relative ? shownPercent(comparison.deviation) : shown(comparison.deviation);
    const std::string tolerance = relative ? shown(100.0 * expected.tolerance) + " %" : shown(expected.tolerance);
    return {expected.quantity,
            measuredText(comparison.measured),
            shown(expected.value),
            known ? deviation : "",
            tolerance,
            verdictOf(comparison, whole),
            known ? expected.source : comparison.measured.problem};
}

std::string expectedTable(const RecordedRun& run, const std::vector<StageRecord>& records) {
    const bool whole = isWhole(records);
    std::vector<TextRow> rows;
    for (const Expected& expected : run.scene.about.expected)
        rows.push_back(expectedRow(compare(expected, run), whole));
    if (rows.empty())
        return {};
    return "\n" + textTable({{"expected by the scene"},
                             {"computed", Align::Right},
                             {"expected", Align::Right},
                             {"deviation", Align::Right},
                             {"tolerance", Align::Right},
                             {"verdict"},
                             {""}},
                            rows);
}

}  // namespace

std::optional<RunHealth> healthOf(const std::vector<StageRecord>& records) {
    RunHealth total;
    long steps = 0;
    long passes = 0;
    long solved = 0;
    long awake = 0;
    long movable = 0;
    StepWork work;
    bool any = false;
    for (const StageRecord& record : records) {
        if (!record.ended)
            continue;
        const Health& health = record.result.health;
        any = true;
        steps += record.result.steps;
        passes += health.passes;
        solved += health.steps;
        work += health.work;
        awake += health.awake;
        movable += health.movable;
        total.stepCuts += health.stepCuts;
        total.energyCuts += health.energyCuts;
        total.maxPenetrationRatio = std::max(total.maxPenetrationRatio, health.maxPenetrationRatio);
        total.residual = std::max(total.residual, health.maxResidual);
        if (std::abs(health.balanceError) > std::abs(total.balanceError))
            total.balanceError = health.balanceError;
    }
    if (!any)
        return std::nullopt;
    const auto solves = static_cast<double>(std::max(1L, solved));
    if (movable > 0)
        total.awakeMean = static_cast<double>(awake) / static_cast<double>(movable);
    total.workMean = workOf(work) / solves;
    total.factorizationsMean = static_cast<double>(work.factorizations) / solves;
    total.fullFactorizationsMean = static_cast<double>(work.fullFactorizations) / solves;
    total.passesMean = steps > 0 ? static_cast<double>(passes) / static_cast<double>(steps) : 0.0;
    return total;
}

std::string summaryOf(const RunSource& run, const std::map<int, double>& stageSeconds) {
    const std::vector<StageRecord> records = run.stages();
    const std::vector<Event> events = run.events();
    const std::vector<HistoryRow> history = run.history();
    std::string text = run.scene().title.empty() ? "" : visibleText(run.scene().title) + "\n\n";
    text += stageTable(run.scene(), records, stageSeconds) + messages(run.scene(), records) + "\n" + verdictText(run);
    text += "preset  " + presetText(run.scene().analysis) + "\n";
    text += "frames  " + std::to_string(run.frames().size()) + "\n" + eventLine(events) + healthLine(records);
    text += chainLines(run, events) + boltUseTable(run) + boltEnergyTable(run);
    const RecordedRun recorded{run.scene(), history, events, records};
    return text + quantityTable(recorded) + expectedTable(recorded, records);
}

}  // namespace keyblock::cli
