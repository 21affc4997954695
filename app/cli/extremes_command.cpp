// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `verify --extremes`: runs scenes with known answers to and past the limits
// of the method, prints how each run ended, and writes the help page of the limits.
#include "app/cli/extremes_command.h"

#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/text_table.h"
#include "solver/files/atomic_file.h"
#include "solver/verify/extremes/limits_page.h"

#include <algorithm>
#include <ostream>

namespace keyblock::cli {

namespace {

const std::vector<TextColumn> caseColumns{{"case", Align::Left, 32},    {"runs", Align::Right, 5},
                                          {"right", Align::Right, 6},   {"refused", Align::Right, 8},
                                          {"stopped", Align::Right, 8}, {"warned", Align::Right, 7},
                                          {"wrong", Align::Right, 6},   {"seconds", Align::Right, 9}};

TextRow countsRow(const std::string& name, const std::vector<ExtremeRun>& runs) {
    const ExtremeCounts counts = countsOf(runs);
    double seconds = 0.0;
    for (const ExtremeRun& run : runs) seconds += run.seconds;
    TextRow row{name, std::to_string(counts.all())};
    for (const ExtremeEnding ending : {ExtremeEnding::Right, ExtremeEnding::Refused, ExtremeEnding::Stopped,
                                       ExtremeEnding::Warned, ExtremeEnding::Wrong})
        row.push_back(std::to_string(counts.of(ending)));
    row.push_back(shownSeconds(seconds));
    return row;
}

std::string runLine(const ExtremeRun& run) {
    std::string line = "  " + run.value + ": " + std::string(wordOf(run.ending));
    if (!run.quantity.empty())
        line += ", " + run.quantity + " " + shown(run.measured) + ", expected " + shown(run.expected) + " ± " +
                shown(run.tolerance);
    if (!run.reason.empty()) line += "; " + run.reason;
    return line + "\n";
}

/// A case is chosen by its name, by the name of its scene, or by that of its axis.
std::vector<ExtremeCase> chosenExtremes(const std::vector<std::string>& names) {
    if (names.empty()) return extremeCases();
    std::vector<ExtremeCase> chosen;
    for (const std::string& name : names) {
        const std::size_t before = chosen.size();
        for (const ExtremeCase& one : extremeCases()) {
            const std::size_t slash = one.name.find('/');
            if (one.name == name || one.name.substr(0, slash) == name || one.name.substr(slash + 1) == name)
                chosen.push_back(one);
        }
        if (chosen.size() > before) continue;
        std::string all;
        for (const ExtremeCase& one : extremeCases()) all += (all.empty() ? "" : ", ") + one.name;
        throw UsageError("there is no extreme '" + name + "'; there are " + all);
    }
    return chosen;
}

std::vector<ExtremeCaseRuns> runCases(const VerifyOptions& options) {
    std::vector<ExtremeCaseRuns> all;
    for (const ExtremeCase& one : chosenExtremes(options.names)) {
        if (readerIsGone()) break;
        ExtremeCaseRuns runs{one, {}};
        for (std::size_t i = 0; i < one.values.size(); ++i) runs.runs.push_back(one.run(i));
        if (!options.json) {
            print(textLine(caseColumns, countsRow(one.name, runs.runs)));
            for (const ExtremeRun& run : runs.runs)
                if (!options.names.empty() || run.ending == ExtremeEnding::Wrong) print(runLine(run));
        }
        all.push_back(std::move(runs));
    }
    return all;
}

RandomExtremes runRandom(const VerifyOptions& options) {
    RandomExtremes random{options.seed, {}};
    if (!options.json) print("random combinations, seed " + std::to_string(options.seed) + "\n");
    for (int number = 0; number < options.random && !readerIsGone(); ++number) {
        random.runs.push_back(randomExtreme(options.seed, number));
        if (!options.json && random.runs.back().ending == ExtremeEnding::Wrong)
            print("  " + std::to_string(number) + runLine(random.runs.back()));
    }
    if (!options.json) print(textLine(caseColumns, countsRow("random", random.runs)));
    return random;
}

std::string summary(const std::vector<ExtremeRun>& runs) {
    const ExtremeCounts counts = countsOf(runs);
    std::string text = std::to_string(counts.all()) + " runs:";
    for (const ExtremeEnding ending : {ExtremeEnding::Right, ExtremeEnding::Refused, ExtremeEnding::Stopped,
                                       ExtremeEnding::Warned, ExtremeEnding::Wrong})
        text += " " + std::to_string(counts.of(ending)) + " " + std::string(wordOf(ending)) +
                (ending == ExtremeEnding::Wrong ? "" : ",");
    return text + "; median " + shownSeconds(counts.median) + " s, longest " + shownSeconds(counts.longest) + " s\n";
}

}  // namespace

ExitCode performExtremes(const VerifyOptions& options) {
    const bool onlyRandom = options.random > 0 && !options.page && options.names.empty();
    if (!options.json)
        print(textLine(caseColumns, {"case", "runs", "right", "refused", "stopped", "warned", "wrong", "seconds"}));
    std::vector<ExtremeCaseRuns> cases;
    if (!onlyRandom) cases = runCases(options);
    std::vector<RandomExtremes> random;
    if (options.random > 0) random.push_back(runRandom(options));
    std::vector<ExtremeRun> all;
    for (const ExtremeCaseRuns& one : cases) all.insert(all.end(), one.runs.begin(), one.runs.end());
    for (const RandomExtremes& each : random) all.insert(all.end(), each.runs.begin(), each.runs.end());
    if (options.page) writeAtomically(*options.page, [&](std::ostream& out) { out << limitsPage(cases, random); });
    if (options.json) print(extremesJson(cases, random));
    else print("\n" + summary(all));
    return countsOf(all).of(ExtremeEnding::Wrong) == 0 ? Done : Missed;
}

}  // namespace keyblock::cli
