// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history holds a row just before and one just after every event, at the
// event's own time. `first KIND MONITOR` therefore needs no interpolation: it is
// the row before, which is found by counting the events that share the time.
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
        return problem("the run left no value of it");
    switch (reduction) {
        case Reduction::Max: return {*std::max_element(values.begin(), values.end()), ""};
        case Reduction::Min: return {*std::min_element(values.begin(), values.end()), ""};
        default: return {values.back(), ""};
    }
}

template <typename Timed>
bool sameTime(const Timed& a, const Event& b) {
    return a.stage == b.stage && a.time == b.time;
}

/// The row just before `events[index]`; null where the history has none at its time.
const HistoryRow* rowBefore(std::size_t index, std::span<const HistoryRow> history, std::span<const Event> events) {
    const Event& event = events[index];
    std::vector<const HistoryRow*> rows;
    for (const HistoryRow& row : history)
        if (sameTime(row, event))
            rows.push_back(&row);
    if (rows.empty())
        return nullptr;
    const auto atThatTime = [&](const Event& other) { return sameTime(other, event); };
    const auto earlier = static_cast<std::size_t>(
        std::count_if(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(index), atThatTime));
    return rows[std::min(2 * earlier, rows.size() - 1)];
}

Measurement atFirst(const Quantity& quantity, std::span<const HistoryRow> history, std::span<const Event> events,
                    std::size_t column) {
    const auto kind = static_cast<EventKind>(quantity.eventKind);
    const auto found = std::find_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; });
    if (found == events.end())
        return problem("no " + std::string(eventKindWords[static_cast<std::size_t>(quantity.eventKind)]) +
                       " happened");
    const HistoryRow* row = rowBefore(static_cast<std::size_t>(found - events.begin()), history, events);
    if (!row)
        return problem("the history has no row at the event");
    return {row->values[column], ""};
}

}  // namespace

Measurement measure(const Quantity& quantity, const Scene& scene, std::span<const HistoryRow> history,
                    std::span<const Event> events) {
    const auto column = static_cast<std::size_t>(historyColumn(scene, quantity.subject));
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

Comparison compare(const Expected& expected, const Scene& scene, std::span<const HistoryRow> history,
                   std::span<const Event> events) {
    Comparison comparison{expected, measure(expected.quantity, scene, history, events)};
    if (!comparison.measured.value)
        return comparison;
    const double difference = *comparison.measured.value - expected.value;
    comparison.deviation = expected.value == 0.0 ? difference : difference / std::abs(expected.value);
    comparison.within = std::abs(comparison.deviation) <= expected.tolerance;
    return comparison;
}

}  // namespace keyblock
