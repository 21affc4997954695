// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/sweep_results.h"

#include "solver/files/read_error.h"
#include "solver/files/sha256.h"
#include "solver/files/text_file.h"
#include "solver/scene/quantity_text.h"
#include "solver/study/case_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t mostTableBytes = std::uint64_t{1} << 30;

double numberIn(const std::string& cell) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    return error == std::errc() && end == cell.data() + cell.size() ? number : noNumber;
}

/// Cells of all rows of cases.csv.
std::vector<std::vector<std::string>> readCells(const Sweep& sweep) {
    const fs::path path = sweep.folder / sweepCasesName;
    const std::string text = readTextFile(path, {mostTableBytes, "plan the sweep again", "plan the sweep again"});
    if (sha256(text) != sweep.plan.casesHash)
        throw CannotRead("cannot read " + path.string() +
                         ": it was changed after the sweep was planned; plan the sweep again");
    std::vector<std::vector<std::string>> rows;
    for (std::size_t from = text.find('\n') + 1; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        rows.push_back(cellsOf(text.substr(from, end - from)));
        rows.back().erase(rows.back().begin());
        from = end + 1;
    }
    return rows;
}

using ReadNumber = std::function<std::optional<double>(const SweepCaseResult&)>;

SweepColumn columnOf(const SweepResults& results, std::string name, ColumnRole role, const ReadNumber& read) {
    SweepColumn column{std::move(name), role, {}};
    for (const std::optional<SweepCaseResult>& one : results.cases)
        column.values.push_back(one ? read(*one).value_or(noNumber) : noNumber);
    return column;
}

std::optional<double> flagNumber(std::optional<bool> flag) {
    return flag ? std::optional(*flag ? 1.0 : 0.0) : std::nullopt;
}

/// A case that did not run to its end has values of a part of the run, which are no results.
bool hasResults(const SweepCaseResult& one) { return one.outcome == CaseOutcome::Done; }

void addParameterColumns(SweepResults& results) {
    for (std::size_t p = 0; p < results.parameters.size(); ++p) {
        SweepColumn column{results.parameters[p], ColumnRole::Parameter, {}};
        for (const std::vector<std::string>& row : results.cells) column.values.push_back(numberIn(row[p]));
        results.columns.push_back(std::move(column));
    }
}

void addResultColumns(SweepResults& results, const Study& study) {
    for (std::size_t f = 0; f < study.faults.size(); ++f)
        results.columns.push_back(
            columnOf(results, study.faults[f].name, ColumnRole::Fault, [f](const SweepCaseResult& one) {
                return f < one.faultMeasures.size() ? std::optional(one.faultMeasures[f]) : std::nullopt;
            }));
    if (!results.criterion.empty())
        results.columns.push_back(columnOf(results, "fails", ColumnRole::Verdict,
                                           [](const SweepCaseResult& one) { return flagNumber(one.fails); }));
    for (std::size_t q = 0; q < results.quantities.size(); ++q) {
        if (results.quantities[q] == "factor_of_safety") continue;
        results.columns.push_back(
            columnOf(results, results.titles[q], ColumnRole::Result, [q](const SweepCaseResult& one) {
                return hasResults(one) && q < one.values.size() ? one.values[q].value : std::nullopt;
            }));
    }
    if (results.hasSafety)
        results.columns.push_back(
            columnOf(results, "factor_of_safety", ColumnRole::Result,
                     [](const SweepCaseResult& one) { return hasResults(one) ? one.safetyLower : std::nullopt; }));
}

}  // namespace

long SweepResults::finished() const {
    return std::ranges::count_if(cases, [](const auto& one) { return one.has_value(); });
}

std::string columnTitle(const std::string& quantity, const Scene& scene) {
    const QuantityReading reading = readQuantity(quantity, scene);
    const auto ofBolt = [](BoltQuantity which) {
        const BoltQuantityRow& row = rowOf(which);
        return std::string(row.column.substr(row.key.size()));
    };
    if (!reading.quantity) return quantity;
    const Subject& subject = reading.quantity->subject;
    if (subject.bolt >= 0) return quantity + ofBolt(subject.boltQuantity);
    if (subject.monitor < 0) return quantity;
    const Monitor& monitor = scene.monitors[subject.monitor];
    return quantity + (monitor.bolt ? ofBolt(monitor.quantity) : "_m");
}

SweepResults plannedResults(const Sweep& sweep, const std::vector<std::string>& quantities) {
    SweepResults results;
    for (const StudyParameter& parameter : sweep.study.parameters) results.parameters.push_back(parameter.name);
    results.cells = readCells(sweep);
    results.quantities = quantities;
    const SceneReading scene = readSceneText(sweep.sceneText, sweepSceneName, {}, std::nullopt);
    for (const std::string& quantity : quantities)
        results.titles.push_back(scene.scene ? columnTitle(quantity, scene.cut ? scene.cut->scene : *scene.scene)
                                             : quantity);
    results.criterion = sweep.study.fails;
    results.hasSafety = sweep.study.safety;
    results.cases.resize(static_cast<std::size_t>(sweep.plan.cases));
    makeColumns(results, sweep.study);
    return results;
}

bool readCaseInto(SweepResults& results, const Sweep& sweep, long number) {
    const fs::path path = summaryPath(sweep.folder, number);
    std::optional<SweepCaseResult> one = readCaseResult(path, sweep.plan.hash, results.quantities.size());
    if (one && one->number != number)
        throw CannotRead("cannot read " + path.string() + ": it is of another case; delete it and run the case again");
    results.cases[static_cast<std::size_t>(number - 1)] = std::move(one);
    return results.cases[static_cast<std::size_t>(number - 1)].has_value();
}

void makeColumns(SweepResults& results, const Study& study) {
    results.columns.clear();
    addParameterColumns(results);
    addResultColumns(results, study);
}

SweepResults collectResults(const Sweep& sweep, const std::vector<std::string>& quantities) {
    SweepResults results = plannedResults(sweep, quantities);
    for (long number = 1; number <= sweep.plan.cases; ++number) readCaseInto(results, sweep, number);
    makeColumns(results, sweep.study);
    return results;
}

FailureShare failureShare(const SweepResults& results) {
    FailureShare share;
    for (const std::optional<SweepCaseResult>& one : results.cases) {
        if (!one) continue;
        if (!one->fails) ++share.undecided;
        else ++share.decided;
        if (one->fails.value_or(false)) ++share.fails;
    }
    if (share.decided > 0) share.probability = static_cast<double>(share.fails) / static_cast<double>(share.decided);
    share.interval = wilsonInterval(share.fails, share.decided);
    return share;
}

std::vector<ConvergencePoint> convergence(const SweepResults& results) {
    constexpr long mostPoints = 1000;
    const long all = failureShare(results).decided, every = std::max(1L, all / mostPoints);
    std::vector<ConvergencePoint> points;
    long decided = 0, fails = 0;
    for (const std::optional<SweepCaseResult>& one : results.cases) {
        if (!one || !one->fails) continue;
        ++decided;
        fails += *one->fails ? 1 : 0;
        if (decided % every == 0 || decided == all)
            points.push_back(
                {decided, static_cast<double>(fails) / static_cast<double>(decided), wilsonInterval(fails, decided)});
    }
    return points;
}

const SweepColumn* findColumn(const SweepResults& results, std::string_view name) {
    const auto found = std::ranges::find(results.columns, name, &SweepColumn::name);
    return found == results.columns.end() ? nullptr : &*found;
}

std::vector<double> sortedValues(const SweepColumn& column) {
    std::vector<double> values;
    std::ranges::copy_if(column.values, std::back_inserter(values), [](double v) { return std::isfinite(v); });
    std::ranges::sort(values);
    return values;
}

double correlationOf(const SweepColumn& input, const SweepColumn& result) {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < input.values.size(); ++i) {
        if (!std::isfinite(input.values[i]) || !std::isfinite(result.values[i])) continue;
        x.push_back(input.values[i]);
        y.push_back(result.values[i]);
    }
    return rankCorrelation(x, y);
}

}  // namespace keyblock
