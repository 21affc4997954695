// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/reference_curves.h"

#include "solver/scene/suggest.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr std::size_t mostReferences = 4;  // of a panel
constexpr std::array<CurveStyle, mostReferences> styles{CurveStyle::Reference, CurveStyle::SecondReference,
                                                        CurveStyle::ThirdReference, CurveStyle::FourthReference};

/// A title without a known unit belongs to a dimensionless number.
MeasureUnit unitOfTitle(const std::string& title) {
    return measureUnitOf(partedTitle(title).unit).value_or(MeasureUnit{});
}

bool sameName(const std::string& a, const std::string& b) { return plainName(a) == plainName(b); }

/// Whether the panel has a curve of that name.
bool shows(const ChartPanel& panel, const std::string& name) {
    return std::any_of(panel.curves.begin(), panel.curves.end(), [&](const ChartCurve& curve) {
        return !curve.name.empty() && !isReference(curve.style) && sameName(curve.name, name);
    });
}

std::size_t referencesOf(const ChartPanel& panel) {
    return std::count_if(panel.curves.begin(), panel.curves.end(),
                                                  [](const ChartCurve& curve) { return isReference(curve.style); });
}

void widen(ValueRange& range, const std::vector<double>& values) {
    for (const double value : values) range = {std::min(range.low, value), std::max(range.high, value)};
}

std::string inPlainQuotes(const ReferenceColumn& column) {
    return inQuotes(column.title) + " (" + std::string(wordOf(column.measure)) + ")";
}

}  // namespace

ReferencePlacer::ReferencePlacer(const std::vector<ReferenceTable>& tables, const RunTime& time,
                                 std::vector<std::string> stages)
    : tables_(tables), time_(time), stages_(std::move(stages)), hasAxis_(tables.size(), false), faults_(tables.size()) {
    for (const ReferenceTable& table : tables) used_.emplace_back(table.columns.size(), false);
}

void ReferencePlacer::place(Chart& chart) {
    const std::size_t before = seen_.size();
    for (const ChartPanel& panel : chart.panels) {
        std::string names;
        for (const ChartCurve& curve : panel.curves)
            if (!curve.name.empty()) names += (names.empty() ? ": " : ", ") + curve.name;
        seen_.push_back(panel.title + " over " + chart.xTitle + names);
    }
    seen_.erase(std::unique(seen_.begin() + static_cast<std::ptrdiff_t>(before), seen_.end()), seen_.end());
    for (std::size_t t = 0; t < tables_.size(); ++t) {
        int over = -1;
        const std::vector<double> x = abscissas(t, chart, over);
        for (std::size_t c = 0; over >= 0 && c < tables_[t].columns.size(); ++c)
            if (static_cast<int>(c) != over && tables_[t].columns[c].measure != Measure::Time)
                placeColumn(t, c, x, chart);
        const bool any = std::any_of(used_[t].begin(), used_[t].end(), [](bool used) { return used; });
        if (over >= 0 && any) used_[t][over] = true;
    }
}

/// Values for the chart's horizontal axis, in its unit: the column with the name of the axis, or else the only column
/// of the same kind of quantity.
std::vector<double> ReferencePlacer::abscissas(std::size_t t, const Chart& chart, int& found) {
    const ReferenceTable& table = tables_[t];
    const Title axis = partedTitle(chart.xTitle);
    const Measure measure = chart.overTime ? Measure::Time : unitOfTitle(chart.xTitle).measure;
    int count = 0, byName = -1;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const ReferenceColumn& column = table.columns[c];
        if (column.measure != measure) continue;
        if (byName < 0 && sameName(column.name, chart.overTime ? "time" : axis.name)) byName = static_cast<int>(c);
        const bool anotherCurve = std::any_of(chart.panels.begin(), chart.panels.end(), [&](const ChartPanel& panel) {
            return shows(panel, column.name);
        });
        if (!anotherCurve) found = static_cast<int>(c), ++count;
    }
    if (byName >= 0)
        found = byName;
    else if (count != 1)
        found = -1;
    if (byName < 0 && count > 1 && faults_[t].empty())
        faults_[t] = std::to_string(count) + " of its columns may be the axis " + inQuotes(axis.name);
    hasAxis_[t] = hasAxis_[t] || found >= 0;
    if (found < 0) return {};
    std::vector<double> x = table.columns[found].values;
    if (!chart.overTime) {
        const Unit unit = unitOfTitle(chart.xTitle).unit;
        for (double& value : x) value = fromSi(value, unit);
    }
    if (chart.overTime && table.stages.empty())
        for (double& value : x) value = time_.atTotal(value);
    for (std::size_t row = 0; chart.overTime && row < table.stages.size(); ++row) {
        const auto stage = std::find(stages_.begin(), stages_.end(), table.stages[row]);
        const bool known = stage != stages_.end();
        if (!known) faults_[t] = "the run has no stage " + inQuotes(table.stages[row]);
        x[row] = known ? time_.at(static_cast<int>(stage - stages_.begin()), x[row])
                       : std::numeric_limits<double>::quiet_NaN();
    }
    return x;
}

ChartPanel* ReferencePlacer::panelFor(const ReferenceColumn& column, Chart& chart) const {
    const auto fits = [&](const ChartPanel& panel) { return unitOfTitle(panel.title).measure == column.measure; };
    ChartPanel* only = nullptr;
    bool several = false;
    for (ChartPanel& panel : chart.panels) {
        if (!fits(panel)) continue;
        if (shows(panel, column.name) || sameName(partedTitle(panel.title).name, column.name)) return &panel;
        several = several || (only && only->title != panel.title);
        if (!only) only = &panel;
    }
    return several ? nullptr : only;
}

void ReferencePlacer::placeColumn(std::size_t t, std::size_t c, const std::vector<double>& x, Chart& chart) {
    const ReferenceTable& table = tables_[t];
    const ReferenceColumn& column = table.columns[c];
    ChartPanel* panel = panelFor(column, chart);
    if (!panel || referencesOf(*panel) == mostReferences) {
        if (panel) faults_[t] = "the panel " + panel->title + " already has four reference curves";
        return;
    }
    const Unit unit = unitOfTitle(panel->title).unit;
    ChartCurve curve{table.name, styles[referencesOf(*panel)], {}, {}};
    for (std::size_t row = 0; row < x.size(); ++row) {
        if (!std::isfinite(x[row]) || !std::isfinite(column.values[row])) continue;
        curve.x.push_back(x[row]);
        curve.y.push_back(fromSi(column.values[row], unit));
    }
    if (curve.x.empty()) return;
    used_[t][c] = true;
    for (ChartCurve& other : panel->curves)  // two curves from the same file get the names of their columns
        if (isReference(other.style) && other.table == static_cast<int>(t)) {
            other.name = table.name + ": " + other.column;
            curve.name = table.name + ": " + column.name;
        }
    curve.table = static_cast<int>(t);
    curve.column = column.name;
    widen(chart.x, curve.x);
    panel->curves.push_back(std::move(curve));
}

std::vector<Problem> ReferencePlacer::problems() const {
    std::string there;
    for (const std::string& panel : seen_) there += (there.empty() ? "" : "; ") + panel;
    const std::string remedy = "Name columns after curves of the figure, with units of the same kind: " + there;
    std::vector<Problem> found;
    for (std::size_t t = 0; t < tables_.size(); ++t) {
        std::string left;
        std::size_t count = 0;
        for (std::size_t c = 0; c < tables_[t].columns.size(); ++c) {
            if (used_[t][c]) continue;
            left += (left.empty() ? "" : ", ") + inPlainQuotes(tables_[t].columns[c]);
            ++count;
        }
        if (count == 0) continue;
        const bool all = count == tables_[t].columns.size();
        const std::string why = !faults_[t].empty() ? "; " + faults_[t]
                                : !hasAxis_[t]      ? "; it has no column for an axis"
                                                    : "";
        found.push_back({all ? Severity::Error : Severity::Warning, tables_[t].file, 0, "",
                         "no panel matches " + left + why, remedy});
    }
    return found;
}

}  // namespace keyblock
