// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/history_series.h"

#include "solver/results/history.h"
#include "solver/scene/quantity_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace keyblock {

namespace {

struct Shown {
    const char* title;
    double factor;
};

/// In the order of `BoltQuantity`.
constexpr std::array<Shown, boltQuantityWords.size()> shownOfBolts{{{"Axial force (kN)", 1e-3},
                                                                    {"Shear force (kN)", 1e-3},
                                                                    {"Moment (kN m)", 1e-3},
                                                                    {"Bond force (kN)", 1e-3},
                                                                    {"Slip of bolts (mm)", 1e3},
                                                                    {"Plate force (kN)", 1e-3},
                                                                    {"Debonded length (m)", 1.0},
                                                                    {"Strain of bolts (mm/m)", 1e3},
                                                                    {"Utilisation", 1.0},
                                                                    {"Utilisation with moment", 1.0}}};

bool isForce(const char* title) { return std::string_view(title).ends_with("(kN)"); }

}  // namespace

std::vector<Series> monitorSeries(const Scene& scene) {
    std::vector<Series> all;
    for (std::size_t m = 0; m < scene.monitors.size(); ++m) {
        const Monitor& monitor = scene.monitors[m];
        const auto column = [&](int component) {
            return static_cast<std::size_t>(historyColumn(scene, {static_cast<int>(m), component, -1, {}}));
        };
        if (monitor.point) {
            all.push_back({monitor.name + ".ux", "Displacement along x (mm)", column(0), 1e3, false, false});
            all.push_back({monitor.name + ".uy", "Displacement along y (mm)", column(1), 1e3, false, false});
        } else if (monitor.between) {
            all.push_back({monitor.name, "Opening (mm)", column(0), 1e3, false, true});
        } else {
            const Shown& shown = shownOfBolts[static_cast<std::size_t>(monitor.quantity)];
            all.push_back({monitor.name, shown.title, column(0), shown.factor, isForce(shown.title), false});
        }
    }
    return all;
}

std::vector<Series> allSeries(const RunSource& run) {
    const Scene& scene = run.scene();
    std::vector<Series> all = monitorSeries(scene);
    for (std::size_t b = 0; b < scene.bolts.size(); ++b)
        for (std::size_t q = 0; q < shownOfBolts.size(); ++q) {
            const Shown& shown = shownOfBolts[q];
            const int column = historyColumn(scene, {-1, 0, static_cast<int>(b), static_cast<BoltQuantity>(q)});
            all.push_back({scene.bolts[b].name + "." + std::string(boltQuantityWords[q]), shown.title,
                           static_cast<std::size_t>(column), shown.factor, isForce(shown.title), false});
        }
    const bool small = hasSmallEnergies(run.frames());
    for (const FrameQuantity<Energy>& row : energyQuantities())
        if (!row.display.unit.empty())
            all.push_back({"energy." + std::string(row.name), small ? "Energy (J)" : "Energy (kJ)", 0,
                           small ? 1.0 : 1e-3, false, false, &row});
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

bool hasSmallEnergies(const std::vector<FrameHead>& frames) {
    double largest = 0.0;
    for (const FrameQuantity<Energy>& row : energyQuantities())
        if (!row.display.unit.empty())
            for (const FrameHead& frame : frames) largest = std::max(largest, std::abs(row.value(frame.energy)));
    return largest < 1e3;
}

}  // namespace keyblock
