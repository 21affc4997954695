// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Columns are found by position, not by name: two monitors whose names differ only in
// a space and an underscore share a column name but never a column.
#include "solver/results/history.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int magnitude = 2;  // `Subject::component` of the magnitude of a displacement

/// The unit as the suffix of a column name, for example "_N".
std::string unitSuffix(BoltQuantity quantity) {
    return std::string(rowOf(quantity).column.substr(rowOf(quantity).key.size()));
}

std::string columnStem(std::string name) {
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

void addMonitor(const Monitor& monitor, std::vector<std::string>& names) {
    const std::string stem = columnStem(monitor.name);
    if (monitor.point) {
        names.push_back(stem + "_ux_m");
        names.push_back(stem + "_uy_m");
    } else if (monitor.between) {
        names.push_back(stem + "_m");
    } else {
        names.push_back(stem + unitSuffix(monitor.quantity));
    }
}

int firstColumnOf(const Scene& scene, int monitor) {
    int column = 0;
    for (int before = 0; before < monitor; ++before)
        column += monitorValueCount(scene.monitors[before]);
    return column;
}

}  // namespace

HistoryColumns historyColumns(const Scene& scene) {
    HistoryColumns columns;
    for (const Monitor& monitor : scene.monitors)
        addMonitor(monitor, columns.names);
    columns.monitorValues = static_cast<int>(columns.names.size());
    for (const Bolt& bolt : scene.bolts)
        for (const BoltQuantityRow& row : boltQuantityRows)
            columns.names.push_back(bolt.name + "." + std::string(row.key));
    return columns;
}

int historyColumn(const Scene& scene, const Subject& subject) {
    if (subject.monitor >= 0) return firstColumnOf(scene, subject.monitor) + subject.component % magnitude;
    const int monitorValues = firstColumnOf(scene, static_cast<int>(scene.monitors.size()));
    return monitorValues + subject.bolt * static_cast<int>(boltQuantityRows.size()) +
           static_cast<int>(subject.boltQuantity);
}

double valueIn(const HistoryRow& row, const Subject& subject, int column) {
    if (subject.monitor >= 0 && subject.component == magnitude)
        return std::hypot(row.values[column], row.values[column + 1]);
    return row.values[column];
}

}  // namespace keyblock
