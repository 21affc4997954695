// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/readings.h"

#include "solver/results/history.h"
#include "solver/results/quantity.h"
#include "solver/run/run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {

namespace {

constexpr double noReading = std::numeric_limits<double>::quiet_NaN();

std::size_t columnOf(const Scene& scene, const std::string& monitor, int component) {
    const auto found = std::find_if(scene.monitors.begin(), scene.monitors.end(),
                                    [&](const Monitor& m) { return m.name == monitor; });
    Subject subject;
    subject.monitor = static_cast<int>(found - scene.monitors.begin());
    subject.component = component;
    return historyColumn(scene, subject);
}

/// The history row just before an event; null if there is none.
const HistoryRow* rowBefore(const Results& results, const Event& event) {
    return event.historyRow < 0 ? nullptr : &results.history[event.historyRow];
}

bool letsGo(EventKind kind) {
    return kind == EventKind::Debonding || kind == EventKind::TensileRupture || kind == EventKind::ShearRupture ||
           kind == EventKind::PlateLoss;
}

}  // namespace

Solved solve(Scene scene) {
    Results results = runInMemory(scene);
    return {std::move(scene), std::move(results)};
}

double reading(const Solved& solved, const std::string& quantity) {
    return measure(quantity, solved.scene, solved.results).value.value_or(noReading);
}

std::vector<double> series(const Solved& solved, const std::string& monitor, int component) {
    const std::size_t column = columnOf(solved.scene, monitor, component);
    std::vector<double> values;
    for (const HistoryRow& row : solved.results.history) values.push_back(row.values[column]);
    return values;
}

double slidDown(const Solved& solved, double slope) {
    const double angle = slope * std::numbers::pi / 180.0;
    return std::cos(angle) * reading(solved, "last slider.ux") - std::sin(angle) * reading(solved, "last slider.uy");
}

std::vector<std::pair<double, double>> loadPath(const Solved& solved) {
    const std::vector<double> opening = series(solved, "opening"), load = series(solved, "joint force");
    std::vector<std::pair<double, double>> path;
    for (std::size_t i = 0; i < opening.size(); ++i) path.emplace_back(opening[i], load[i]);
    return path;
}

double loadAtOpening(const std::vector<std::pair<double, double>>& path, double opening) {
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto& [x0, y0] = path[i - 1];
        const auto& [x1, y1] = path[i];
        if (x0 <= opening && opening <= x1 && x1 > x0) return y0 + (y1 - y0) * (opening - x0) / (x1 - x0);
    }
    return noReading;
}

std::vector<Release> releases(const Solved& solved) {
    const std::size_t opening = columnOf(solved.scene, "opening", 0), load = columnOf(solved.scene, "joint force", 0);
    std::vector<Release> found;
    for (const Event& event : solved.results.events) {
        if (!letsGo(event.kind)) continue;
        const HistoryRow* row = rowBefore(solved.results, event);
        const bool ofElement = event.kind == EventKind::TensileRupture || event.kind == EventKind::ShearRupture;
        found.push_back({event.kind, ofElement ? event.element : event.node, row ? row->values[opening] : noReading,
                         row ? row->values[load] : noReading});
    }
    return found;
}

int agreeing(const std::vector<Release>& found, const std::vector<int>& nodes) {
    std::size_t same = 0;
    while (same < found.size() && same < nodes.size() && found[same].index == nodes[same]) ++same;
    return static_cast<int>(same);
}

int countOf(const Solved& solved, EventKind kind) {
    return static_cast<int>(std::count_if(solved.results.events.begin(), solved.results.events.end(),
                                          [&](const Event& e) { return e.kind == kind; }));
}

}  // namespace keyblock
