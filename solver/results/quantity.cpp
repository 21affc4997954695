// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The history has a row just before and a row just after every event, both at the time
// of the event, and each event refers to the row before it. `first KIND MONITOR`
// therefore needs no interpolation, however many events occur at the same time.
#include "solver/results/quantity.h"

#include "solver/results/history.h"
#include "solver/results/result_names.h"
#include "solver/results/verdict.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keyblock {

namespace {

Measurement problem(std::string text) { return {std::nullopt, std::move(text), {}}; }

Measurement reduced(const Quantity& quantity, const RecordedRun& run) {
    const int column = historyColumn(run.scene, quantity.subject);
    std::vector<double> values;
    for (const HistoryRow& row : run.history)
        if (const double value = valueIn(row, quantity.subject, column); !std::isnan(value)) values.push_back(value);
    if (values.empty())
        return problem("the run has no value of it");
    switch (quantity.kind) {
        case QuantityKind::Max: return {*std::max_element(values.begin(), values.end()), "", {}};
        case QuantityKind::Min: return {*std::min_element(values.begin(), values.end()), "", {}};
        default: return {values.back(), "", {}};
    }
}

Measurement atFirst(const Quantity& quantity, const RecordedRun& run) {
    const auto kind = static_cast<EventKind>(quantity.eventKind);
    const auto found = std::find_if(run.events.begin(), run.events.end(),
                                    [&](const Event& e) { return e.kind == kind; });
    if (found == run.events.end()) return problem("no " + std::string(rowOf(kind).key) + " happened");
    if (found->historyRow < 0 || static_cast<std::size_t>(found->historyRow) >= run.history.size())
        return problem("the history has no row before the event");
    return {
        valueIn(run.history[found->historyRow], quantity.subject, historyColumn(run.scene, quantity.subject)), "", {}};
}

/// What an event happened to: a bolt, a joint between two blocks, or a block.
std::string subjectOf(const Event& event, const Scene& scene, const std::vector<std::string>& blocks) {
    if (event.bolt >= 0) return scene.bolts[event.bolt].name;
    const std::string block = blockName(blocks, event.block);
    return event.otherBlock >= 0 ? block + " on " + blockName(blocks, event.otherBlock) : block;
}

Measurement orderOf(EventKind kind, const RecordedRun& run) {
    const std::vector<std::string> blocks = blockNames(run.scene);
    Measurement result;
    for (const Event& event : run.events) {
        if (event.kind != kind) continue;
        std::string subject = subjectOf(event, run.scene, blocks);
        if (!std::count(result.order.begin(), result.order.end(), subject)) result.order.push_back(std::move(subject));
    }
    if (result.order.empty()) return problem("no " + std::string(rowOf(kind).key) + " happened");
    return result;
}

Measurement countOf(EventKind kind, const RecordedRun& run) {
    const auto count = std::count_if(run.events.begin(), run.events.end(),
                                     [&](const Event& e) { return e.kind == kind; });
    return {static_cast<double>(count), "", {}};
}

/// Largest energy balance error of the stages that have ended.
Measurement energyError(const RecordedRun& run) {
    std::optional<double> largest;
    for (const StageRecord& record : run.stages)
        if (record.ended) largest = std::max(largest.value_or(0.0), std::abs(record.result.health.balanceError));
    return largest ? Measurement{largest, "", {}} : problem("no stage has ended");
}

Measurement stands(const RecordedRun& run) {
    const std::optional<bool> stands = verdictOf({run.stages.begin(), run.stages.end()}, run.scene).stands;
    return stands ? Measurement{*stands ? 1.0 : 0.0, "", {}} : problem("stability is undecided");
}

}  // namespace

Measurement measure(const Quantity& quantity, const RecordedRun& run) {
    switch (quantity.kind) {
        case QuantityKind::First: return atFirst(quantity, run);
        case QuantityKind::Count: return countOf(static_cast<EventKind>(quantity.eventKind), run);
        case QuantityKind::Order: return orderOf(static_cast<EventKind>(quantity.eventKind), run);
        case QuantityKind::EnergyError: return energyError(run);
        case QuantityKind::FactorOfSafety: return problem("takes many runs: 'keyblock safety' finds it");
        case QuantityKind::Stands: return stands(run);
        default: return reduced(quantity, run);
    }
}

Measurement measure(std::string_view text, const RecordedRun& run) {
    const QuantityReading reading = readQuantity(text, run.scene);
    if (!reading.quantity)
        return problem(reading.problem);
    return measure(*reading.quantity, run);
}

Measurement measure(std::string_view text, const Scene& scene, const Results& results) {
    std::vector<StageRecord> stages;
    for (const StageResult& result : results.stages) stages.push_back({result, true});
    return measure(text, {scene, results.history, results.events, stages});
}

std::string orderText(const std::vector<std::string>& order, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most, order.size()); ++i) text += (i == 0 ? "" : ", ") + order[i];
    if (order.size() > most) text += ", and " + std::to_string(order.size() - most) + " more";
    return text;
}

MeasuredComparison compare(const Expected& expected, const RecordedRun& run) {
    MeasuredComparison comparison{expected, measure(expected.quantity, run)};
    if (!comparison.measured.value)
        return comparison;
    const double difference = *comparison.measured.value - expected.value;
    comparison.deviation = expected.value == 0.0 ? difference : difference / std::abs(expected.value);
    comparison.within = std::abs(comparison.deviation) <= expected.tolerance;
    return comparison;
}

}  // namespace keyblock
