// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history has a row just before and a row just after every event, both at the time
// of the event, and each event refers to the row before it. `first KIND MONITOR`
// therefore needs no interpolation, however many events occur at the same time.
#include "solver/results/quantity.h"

#include "solver/results/history.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keyblock {

namespace {

Measurement problem(std::string text) { return {std::nullopt, std::move(text)}; }

Measurement reduced(Reduction reduction, std::span<const HistoryRow> history, std::size_t column) {
    std::vector<double> values;
    for (const HistoryRow& row : history)
        if (!std::isnan(row.values[column]))
            values.push_back(row.values[column]);
    if (values.empty())
        return problem("the run has no value of it");
    switch (reduction) {
        case Reduction::Max: return {*std::max_element(values.begin(), values.end()), ""};
        case Reduction::Min: return {*std::min_element(values.begin(), values.end()), ""};
        default: return {values.back(), ""};
    }
}

Measurement atFirst(const Quantity& quantity, std::span<const HistoryRow> history, std::span<const Event> events,
                    std::size_t column) {
    const auto kind = static_cast<EventKind>(quantity.eventKind);
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; });
    if (found == events.end())
        return problem("no " + std::string(rowOf(kind).key) + " happened");
    if (found->historyRow < 0 || static_cast<std::size_t>(found->historyRow) >= history.size())
        return problem("the history has no row before the event");
    return {history[found->historyRow].values[column], ""};
}

}  // namespace

Measurement measure(const Quantity& quantity, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events) {
    const std::size_t column = historyColumn(scene, quantity.subject);
    if (quantity.reduction == Reduction::First)
        return atFirst(quantity, history, events, column);
    return reduced(quantity.reduction, history, column);
}

Measurement measure(std::string_view text, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events) {
    const QuantityReading reading = readQuantity(text, scene);
    if (!reading.quantity)
        return problem(reading.problem);
    return measure(*reading.quantity, scene, history, events);
}

Measurement measure(std::string_view text, const Scene& scene, const Results& results) {
    return measure(text, scene, results.history, results.events);
}

MeasuredComparison compare(const Expected& expected, const Scene& scene, std::span<const HistoryRow> history,
                   std::span<const Event> events) {
    MeasuredComparison comparison{expected, measure(expected.quantity, scene, history, events)};
    if (!comparison.measured.value)
        return comparison;
    const double difference = *comparison.measured.value - expected.value;
    comparison.deviation = expected.value == 0.0 ? difference : difference / std::abs(expected.value);
    comparison.within = std::abs(comparison.deviation) <= expected.tolerance;
    return comparison;
}

}  // namespace keyblock
