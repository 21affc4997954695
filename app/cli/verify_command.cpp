// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `verify`: runs the cases of the suite one after another and prints the
// computed values next to the expected ones, or prints the tables of the paper. A case
// that does not run counts as missed and does not stop the others.
#include "app/cli/cli_commands.h"
#include "app/cli/extremes_command.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/text_table.h"
#include "app/cli/verification_note.h"
#include "solver/verify/verify.h"

#include <algorithm>
#include <exception>
#include <limits>

namespace keyblock::cli {

namespace {

std::string caseNames() {
    std::string names;
    for (const Case& one : cases())
        names += (names.empty() ? "" : ", ") + one.name;
    return names;
}

std::vector<Case> chosenCases(const std::vector<std::string>& names) {
    if (names.empty())
        return cases();
    std::vector<Case> chosen;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(cases().begin(), cases().end(), [&](const Case& one) { return one.name == name; });
        if (found == cases().end())
            throw UsageError("there is no case '" + name + "'; there are " + caseNames());
        chosen.push_back(*found);
    }
    return chosen;
}

CaseResult broken(const Case& one, const std::string& reason) {
    CaseResult result;
    result.name = one.name;
    result.quantity = "did not run: " + reason;
    result.measured = std::numeric_limits<double>::quiet_NaN();
    result.expected = std::numeric_limits<double>::quiet_NaN();
    return result;
}

std::vector<CaseResult> resultsOf(const Case& one) {
    try {
        return one.run();
    } catch (const std::exception& error) {
        return {broken(one, error.what())};
    }
}

/// Wide enough for most quantities, so that rows of all cases are aligned.
const std::vector<TextColumn> caseColumns{{"", Align::Left, 0},          {"", Align::Left, 62},
                                          {"", Align::Right, 12},        {"", Align::Right, 12},
                                          {"", Align::Right, 10},        {"", Align::Right, 9},
                                          {"", Align::Left, 4}};

std::string tolerance(const CaseResult& result) {
    return result.relative ? shown(100.0 * result.tolerance) + " %" : shown(result.tolerance);
}

TextRow caseRow(const CaseResult& result) {
    return {"",
            result.quantity,
            shown(result.measured),
            shown(result.expected),
            tolerance(result),
            shownSeconds(result.seconds),
            result.passed ? "ok" : "MISS"};
}

template <typename Results>
ExitCode verdict(const Results& results) {
    const bool passed = std::all_of(results.begin(), results.end(), [](const auto& one) { return one.passed; });
    return passed ? Done : Missed;
}

/// Runs the cases one after another. Prints each as it finishes, unless the output is JSON.
std::vector<CaseResult> resultsOfAll(const std::vector<Case>& chosen, bool quiet) {
    std::vector<CaseResult> all;
    for (const Case& one : chosen) {
        if (readerIsGone()) break;
        if (!quiet)
            print(one.name + ": " + one.description + "\n");
        for (const CaseResult& result : resultsOf(one)) {
            if (!quiet)
                print(textLine(caseColumns, caseRow(result)));
            all.push_back(result);
        }
    }
    return all;
}

ExitCode performCases(const VerifyOptions& options) {
    const std::vector<Case> chosen = chosenCases(options.names);
    if (!options.json)
        print(textLine(caseColumns, {"", "", "computed", "expected", "tolerance", "seconds", ""}));
    const std::vector<CaseResult> all = resultsOfAll(chosen, options.json);
    if (options.names.empty() && !readerIsGone()) recordVerification(all, chosen.size());
    const auto missed = std::count_if(all.begin(), all.end(), [](const CaseResult& one) { return !one.passed; });
    if (options.json)
        print(casesJson(all));
    else
        print("\n" + std::to_string(all.size()) + " numbers in " + std::to_string(chosen.size()) + " cases, " +
              std::to_string(missed) + " missed\n");
    return verdict(all);
}

std::string paperTableText(const PaperTable& table) {
    const auto orDash = [](const std::optional<double>& value) { return value ? shown(*value) : "–"; };
    std::vector<TextRow> rows;
    for (const PaperRow& row : table.rows) {
        const bool judged = row.reference.has_value();
        rows.push_back({row.quantity, row.unit, orDash(row.paper), orDash(row.reference), shown(row.keyblock),
                        judged ? shown(100.0 * row.tolerance) + " %" : "",
                        row.passed ? (judged ? "ok" : "") : "MISS"});
    }
    return table.title + "\n" + textTable({{"quantity"},
                                           {"unit"},
                                           {"paper", Align::Right},
                                           {"reference", Align::Right},
                                           {"Keyblock", Align::Right},
                                           {"tolerance", Align::Right},
                                           {""}},
                                          rows);
}

ExitCode performPaper(const VerifyOptions& options) {
    const std::vector<PaperTable> tables = paperTables();
    std::vector<PaperRow> rows;
    for (const PaperTable& table : tables)
        rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    if (options.json) {
        print(paperJson(tables));
        return verdict(rows);
    }
    for (const PaperTable& table : tables)
        print(paperTableText(table) + "\n");
    return verdict(rows);
}

}  // namespace

ExitCode perform(const VerifyOptions& options) {
    if (options.extremes) return performExtremes(options);
    return options.paper ? performPaper(options) : performCases(options);
}

}  // namespace keyblock::cli
