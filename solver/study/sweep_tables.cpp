// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/atomic_file.h"
#include "solver/results/csv.h"
#include "solver/study/sweep_results.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keyblock {

namespace {

using TableJson = nlohmann::ordered_json;

constexpr std::array quantileShares{0.05, 0.25, 0.5, 0.75, 0.95};

bool isInput(const SweepColumn& column) {
    return column.role == ColumnRole::Parameter || column.role == ColumnRole::Fault;
}

void endTableRow(CsvWriter& csv, std::initializer_list<std::string_view> cells) {
    for (const std::string_view cell : cells) csv.text(cell);
    csv.endRow();
}

/// A number as it is in cases.csv, or a text.
void putCell(CsvWriter& csv, const std::string& cell) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error == std::errc() && end == cell.data() + cell.size()) csv.number(number);
    else csv.text(cell);
}

void putNumber(CsvWriter& csv, const std::optional<double>& number) {
    if (number && std::isfinite(*number)) csv.number(*number);
    else csv.text("");
}

void putFlag(CsvWriter& csv, std::optional<bool> flag) {
    if (flag) csv.integer(*flag ? 1 : 0);
    else csv.text("");
}

std::string orderCell(const std::vector<std::string>& order) {
    std::string text;
    for (const std::string& name : order) text += (text.empty() ? "" : " > ") + name;
    return text;
}

/// Whether a quantity has a column of its own in every table.
bool hasOwnColumn(const std::string& quantity) { return quantity == "factor_of_safety" || quantity == "stands"; }

void putValues(CsvWriter& csv, const SweepResults& results, const SweepCaseResult* one) {
    for (std::size_t q = 0; q < results.quantities.size(); ++q) {
        if (hasOwnColumn(results.quantities[q])) continue;
        const Measurement* value = one && q < one->values.size() ? &one->values[q] : nullptr;
        if (value && !value->order.empty()) csv.text(orderCell(value->order));
        else putNumber(csv, value ? value->value : std::nullopt);
    }
    if (!results.hasSafety) return;
    putNumber(csv, one ? one->safetyLower : std::nullopt);
    putNumber(csv, one ? one->safetyUpper : std::nullopt);
}

void putCase(CsvWriter& csv, const SweepResults& results, const Study& study, std::size_t index) {
    const SweepCaseResult* one = results.cases[index] ? &*results.cases[index] : nullptr;
    csv.integer(static_cast<long>(index) + 1);
    for (const std::string& cell : results.cells[index]) putCell(csv, cell);
    for (std::size_t f = 0; f < study.faults.size(); ++f)
        putNumber(csv, one && f < one->faultMeasures.size() ? std::optional(one->faultMeasures[f]) : std::nullopt);
    csv.text(one ? wordOf(one->outcome) : "not finished").text(one ? one->reason : "");
    putFlag(csv, one ? one->stands : std::nullopt);
    if (!results.criterion.empty()) putFlag(csv, one ? one->fails : std::nullopt);
    putValues(csv, results, one);
    csv.endRow();
}

TableJson statisticsJson(const SweepColumn& column) {
    const std::vector<double> sorted = sortedValues(column);
    const SampleStatistics s = statisticsOf(sorted);
    TableJson json{{"column", column.name}, {"count", s.count}};
    if (sorted.empty()) return json;
    json.update({{"mean", s.mean}, {"deviation", s.deviation}, {"min", s.least}, {"max", s.most}});
    TableJson quantiles = TableJson::object();
    for (const double share : quantileShares) quantiles[std::to_string(share).substr(0, 4)] = quantileOf(sorted, share);
    json["quantiles"] = quantiles;
    return json;
}

}  // namespace

void writeResultsTable(const SweepResults& results, const Study& study, std::ostream& out) {
    CsvWriter csv(out);
    csv.text("case");
    for (const std::string& name : results.parameters) csv.text(name);
    for (const StudyFault& fault : study.faults) csv.text(fault.name);
    csv.text("outcome").text("reason").text("stands");
    if (!results.criterion.empty()) csv.text("fails");
    for (std::size_t q = 0; q < results.quantities.size(); ++q)
        if (!hasOwnColumn(results.quantities[q])) csv.text(results.titles[q]);
    if (results.hasSafety) csv.text("factor_of_safety").text("factor_of_safety_upper");
    csv.endRow();
    for (std::size_t i = 0; i < results.cases.size(); ++i) putCase(csv, results, study, i);
}

void writeTimingTable(const SweepResults& results, std::ostream& out) {
    CsvWriter csv(out);
    endTableRow(csv, {"case", "host", "cpu_s", "wall_s"});
    for (const std::optional<SweepCaseResult>& one : results.cases)
        if (one) csv.integer(one->number).text(one->host).number(one->cpuSeconds).number(one->wallSeconds).endRow();
}

void writeStatisticsTable(const SweepResults& results, std::ostream& out) {
    CsvWriter csv(out);
    endTableRow(csv, {"column", "count", "mean", "deviation", "min", "q05", "q25", "median", "q75", "q95", "max"});
    for (const SweepColumn& column : results.columns) {
        const std::vector<double> sorted = sortedValues(column);
        if (sorted.empty()) continue;
        const SampleStatistics s = statisticsOf(sorted);
        csv.text(column.name).integer(static_cast<long>(s.count)).number(s.mean).number(s.deviation).number(s.least);
        for (const double share : quantileShares) csv.number(quantileOf(sorted, share));
        csv.number(s.most).endRow();
    }
}

void writeCorrelationsTable(const SweepResults& results, std::ostream& out) {
    CsvWriter csv(out);
    endTableRow(csv, {"result", "input", "rank_correlation"});
    for (const SweepColumn& result : results.columns)
        for (const SweepColumn& input : results.columns)
            if (!isInput(result) && isInput(input) && !sortedValues(result).empty() && !sortedValues(input).empty())
                csv.text(result.name).text(input.name).number(correlationOf(input, result)).endRow();
}

void writeConvergenceTable(const SweepResults& results, std::ostream& out) {
    CsvWriter csv(out);
    endTableRow(csv, {"cases", "probability", "low", "high"});
    for (const ConvergencePoint& p : convergence(results))
        csv.integer(p.cases).number(p.probability).number(p.interval.low).number(p.interval.high).endRow();
}

std::string sweepSummaryText(const SweepResults& results) {
    TableJson outcomes = TableJson::object(), columns = TableJson::array();
    for (const std::optional<SweepCaseResult>& one : results.cases) {
        auto& count = outcomes[one ? std::string(wordOf(one->outcome)) : "not finished"];
        count = count.is_null() ? 1L : count.get<long>() + 1;
    }
    for (const SweepColumn& column : results.columns) columns.push_back(statisticsJson(column));
    TableJson json{{"cases", results.cases.size()}, {"outcomes", outcomes}};
    if (!results.criterion.empty()) {
        const FailureShare share = failureShare(results);
        json["fails"] = {{"criterion", results.criterion},   {"cases", share.fails},
                         {"decided", share.decided},         {"undecided", share.undecided},
                         {"probability", share.probability}, {"low", share.interval.low},
                         {"high", share.interval.high}};
    }
    json["columns"] = columns;
    return json.dump(1) + "\n";
}

void writeSweepTables(const SweepResults& results, const Sweep& sweep) {
    const auto put = [&](const char* name, const auto& write) { writeAtomically(sweep.folder / name, write); };
    put("results.csv", [&](std::ostream& out) { writeResultsTable(results, sweep.study, out); });
    put("timing.csv", [&](std::ostream& out) { writeTimingTable(results, out); });
    put("statistics.csv", [&](std::ostream& out) { writeStatisticsTable(results, out); });
    put("correlations.csv", [&](std::ostream& out) { writeCorrelationsTable(results, out); });
    if (!results.criterion.empty())
        put("convergence.csv", [&](std::ostream& out) { writeConvergenceTable(results, out); });
    put("sweep.json", [&](std::ostream& out) { out << sweepSummaryText(results); });
}

}  // namespace keyblock
