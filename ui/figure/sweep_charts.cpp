// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sweep_charts.h"

#include "solver/scene/number_text.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

bool isVaried(const SweepColumn& column) {
    const std::vector<double> sorted = sortedValues(column);
    return sorted.size() > 1 && sorted.front() < sorted.back();
}

std::vector<const SweepColumn*> variedInputs(const SweepResults& results) {
    std::vector<const SweepColumn*> inputs;
    for (const SweepColumn& column : results.columns)
        if ((column.role == ColumnRole::Parameter || column.role == ColumnRole::Fault) && isVaried(column))
            inputs.push_back(&column);
    return inputs;
}

const SweepColumn* strongestInput(const SweepResults& results, const SweepColumn& result) {
    const SweepColumn* strongest = nullptr;
    double largest = -1.0;
    for (const SweepColumn* input : variedInputs(results))
        if (const double correlation = std::abs(correlationOf(*input, result)); correlation > largest) {
            largest = correlation;
            strongest = input;
        }
    return strongest;
}

HistogramChart histogramOf(const std::string& title, const SweepColumn& column) {
    std::vector<double> sorted = sortedValues(column);
    const std::string subtitle = column.name + " in " + std::to_string(sorted.size()) + " cases";
    return {title, subtitle, column.name, std::move(sorted)};
}

ScatterChart scatterOf(const std::string& title, const SweepResults& results, const ColumnPair& pair) {
    const SweepColumn &x = *pair.x, &y = *pair.y;
    ScatterChart chart{title, "rank correlation " + rounded(correlationOf(x, y)), x.name, y.name, {}};
    const SweepColumn* fails = findColumn(results, "fails");
    for (std::size_t i = 0; i < x.values.size(); ++i)
        if (std::isfinite(x.values[i]) && std::isfinite(y.values[i]))
            chart.dots.push_back(
                {x.values[i], y.values[i], fails && fails->values[i] == 1.0, static_cast<long>(i) + 1});
    return chart;
}

TornadoChart tornadoOf(const std::string& title, const SweepResults& results, const SweepColumn& column) {
    TornadoChart chart{title, "Rank correlation of " + column.name + " with what varies", {}};
    for (const SweepColumn* input : variedInputs(results))
        chart.bars.push_back({input->name, correlationOf(*input, column)});
    std::ranges::stable_sort(chart.bars, std::ranges::greater{},
                             [](const TornadoBar& bar) { return std::abs(bar.value); });
    return chart;
}

ConvergenceChart convergenceChartOf(const std::string& title, const SweepResults& results) {
    ConvergenceChart chart{title, "Probability of failure with its 95 % interval; failure: " + results.criterion, {}};
    for (const ConvergencePoint& p : convergence(results))
        chart.points.push_back({static_cast<double>(p.cases), p.probability, p.interval.low, p.interval.high});
    return chart;
}

}  // namespace keyblock
