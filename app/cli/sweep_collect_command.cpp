// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `sweep collect`: tables, statistics and figures of the cases that are
// finished. It may be used while a sweep is running.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/sweep_figures.h"
#include "app/cli/text_table.h"
#include "solver/scene/number_text.h"
#include "solver/scene/visible_text.h"
#include "solver/study/case_run.h"
#include "solver/study/sweep_results.h"

#include <algorithm>

namespace keyblock::cli {

namespace {

std::string failureText(const SweepResults& results) {
    if (results.criterion.empty()) return "";
    const FailureShare share = failureShare(results);
    if (share.decided == 0) return "no case is decided by the criterion of failure\n";
    std::string text = "probability of failure: " + rounded(share.probability) + " (95 % interval " +
                       rounded(share.interval.low) + " to " + rounded(share.interval.high) +
                       "): " + std::to_string(share.fails) + " of " + std::to_string(share.decided) + " cases fail, " +
                       visibleText(results.criterion) + "\n";
    if (share.undecided > 0)
        text += std::to_string(share.undecided) + " finished cases are not decided and left out of it\n";
    return text;
}

std::string statisticsText(const SweepResults& results) {
    std::vector<TextRow> rows;
    for (const SweepColumn& column : results.columns) {
        if (column.role == ColumnRole::Verdict) continue;
        const std::vector<double> sorted = sortedValues(column);
        if (sorted.empty()) continue;
        const SampleStatistics s = statisticsOf(sorted);
        rows.push_back({visibleText(column.name), rounded(s.mean), rounded(s.deviation),
                        rounded(quantileOf(sorted, 0.05)), rounded(quantileOf(sorted, 0.5)),
                        rounded(quantileOf(sorted, 0.95))});
    }
    return rows.empty() ? ""
                        : "\n" + textTable({{""},
                                            {"mean", Align::Right},
                                            {"deviation", Align::Right},
                                            {"5 %", Align::Right},
                                            {"median", Align::Right},
                                            {"95 %", Align::Right}},
                                           rows);
}

std::string outcomesText(const SweepResults& results) {
    const long finished = results.finished(), all = static_cast<long>(results.cases.size());
    const auto odd = std::ranges::count_if(results.cases,
                                           [](const auto& one) { return one && one->outcome != CaseOutcome::Done; });
    std::string text = std::to_string(finished) + " of " + std::to_string(all) + " cases finished\n";
    if (odd > 0) text += std::to_string(odd) + " of them have no results; results.csv gives the reason of each\n";
    return text;
}

}  // namespace

ExitCode perform(const SweepCollectOptions& options) {
    const Sweep sweep = openSweep(options.sweep);
    const SweepResults results = collectResults(sweep, sweepRunOf(sweep, 1).quantities);
    const std::vector<ColumnPair> pairs = scatterPairs(options.scatter, results);
    writeSweepTables(results, sweep);
    const long figures = drawSweepFigures(results, sweep, pairs);
    print(outcomesText(results) + failureText(results) + statisticsText(results) +
          "\nresults.csv, statistics.csv, "
          "correlations.csv" +
          (figures > 0 ? " and " + std::to_string(figures) + " figures" : "") + " are in " + options.sweep.string() +
          "\n");
    if (results.finished() < sweep.plan.cases)
        printErrorLine("some cases are not finished; run them and collect again");
    return Done;
}

}  // namespace keyblock::cli
