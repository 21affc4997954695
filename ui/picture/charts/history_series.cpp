// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/history_series.h"

#include "solver/results/history.h"
#include "solver/scene/units.h"
#include "ui/picture/ticks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {

namespace {

constexpr double millimetres = perSi(namedUnit("mm"));

/// A quantity of bolts over time.
Series ofBolts(std::string name, const BoltQuantityRow& row, std::size_t column) {
    return {std::move(name), titleWithUnit(row), column, row.factor, row.unit == "kN", false};
}

/// The largest energy of any kind [J].
double largestEnergy(const std::vector<FrameHead>& frames) {
    double largest = 0.0;
    for (const FrameQuantity<Energy>& row : energyQuantities())
        if (!row.display.unit.empty())
            for (const FrameHead& frame : frames)
                if (const double value = row.value(frame.energy); canBeShown(value))
                    largest = std::max(largest, std::abs(value));
    return largest;
}

}  // namespace

std::vector<Series> monitorSeries(const Scene& scene) {
    std::vector<Series> all;
    for (std::size_t m = 0; m < scene.monitors.size(); ++m) {
        const Monitor& monitor = scene.monitors[m];
        const auto column = [&](int component) -> std::size_t {
            return historyColumn(scene, {static_cast<int>(m), component, -1, {}});
        };
        if (monitor.point) {
            all.push_back({monitor.name + ".ux", "Displacement along x (mm)", column(0), millimetres, false, false});
            all.push_back({monitor.name + ".uy", "Displacement along y (mm)", column(1), millimetres, false, false});
        } else if (monitor.between) {
            all.push_back({monitor.name, "Opening (mm)", column(0), millimetres, false, true});
        } else {
            all.push_back(ofBolts(monitor.name, rowOf(monitor.quantity), column(0)));
        }
    }
    return all;
}

std::vector<Series> allSeries(const RunSource& run) {
    const Scene& scene = run.scene();
    std::vector<Series> all = monitorSeries(scene);
    for (std::size_t b = 0; b < scene.bolts.size(); ++b)
        for (const BoltQuantityRow& row : boltQuantityRows) {
            const int column = historyColumn(scene, {-1, 0, static_cast<int>(b), row.quantity});
            all.push_back(ofBolts(scene.bolts[b].name + "." + std::string(row.key), row,
                                  static_cast<std::size_t>(column)));
        }
    const EnergyAxis axis = energyAxis(largestEnergy(run.frames()));
    for (const FrameQuantity<Energy>& row : energyQuantities())
        if (!row.display.unit.empty())
            all.push_back({"energy." + std::string(row.name), axis.title, 0, axis.factor, false, false, &row});
    return all;
}

std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const HistoryRow& row : rows) values.push_back(row.values[series.column] * series.factor);
    return values;
}

std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows,
                             const std::vector<FrameHead>& frames) {
    std::vector<double> values;
    values.reserve(frames.size());
    std::size_t next = 0;
    for (const FrameHead& frame : frames) {
        while (next < rows.size() &&
               std::pair(rows[next].stage, rows[next].time) <= std::pair(frame.stage, frame.time))
            ++next;
        if (series.energy) values.push_back(series.energy->value(frame.energy) * series.factor);
        else if (next > 0) values.push_back(rows[next - 1].values[series.column] * series.factor);
        else values.push_back(std::numeric_limits<double>::quiet_NaN());
    }
    return values;
}

std::string withUnit(const Series& series) {
    const std::size_t unit = series.title.rfind(" (");
    return series.name + (unit == std::string::npos ? "" : series.title.substr(unit));
}

EnergyAxis energyAxis(double largest) {
    constexpr double kilojoules = perSi(namedUnit("kJ"));
    return kilojoules * largest < 1.0 ? EnergyAxis{"Energy (J)", 1.0} : EnergyAxis{"Energy (kJ)", kilojoules};
}

}  // namespace keyblock
