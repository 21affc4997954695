// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/history_charts.h"

#include "solver/results/frame_quantities.h"
#include "solver/results/history.h"
#include "solver/results/words.h"
#include "ui/picture/reference_curves.h"
#include "ui/picture/run_time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keyblock {

namespace {

constexpr std::size_t mostCurves = 4;  // of a panel
constexpr double leastBetweenEvents = 0.005;  // of the chart's width
constexpr double negligible = 1e-3;  // energies below it, of the largest, are not shown
constexpr double nothing = 1e-5;  // of the largest of its kind: nobody could draw or measure it

/// A column of the history as people see it.
struct Series {
    std::string name;
    std::string title;  // of its panel
    std::size_t column = 0;
    double factor = 1.0;
    bool isForce = false, isOpening = false;
};

struct Shown {
    const char* title;
    double factor;
};

/// In the order of `BoltQuantity`.
constexpr std::array<Shown, boltQuantityWords.size()> shownOfBolts{{{"Axial force (kN)", 1e-3},
                                                                    {"Shear force (kN)", 1e-3},
                                                                    {"Moment (N m)", 1.0},
                                                                    {"Bond force (kN)", 1e-3},
                                                                    {"Slip of bolts (mm)", 1e3},
                                                                    {"Plate force (kN)", 1e-3},
                                                                    {"Debonded length (m)", 1.0},
                                                                    {"Strain of bolts (mm/m)", 1e3},
                                                                    {"Utilisation", 1.0},
                                                                    {"Utilisation with moment", 1.0}}};

std::vector<Series> seriesOf(const Scene& scene) {
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
            const bool force = std::string_view(shown.title).ends_with("(kN)");
            all.push_back({monitor.name, shown.title, column(0), shown.factor, force, false});
        }
    }
    return all;
}

std::string withUnit(const Series& series) {
    const std::size_t unit = series.title.rfind(" (");
    return series.name + (unit == std::string::npos ? "" : series.title.substr(unit));
}

bool isOfBolts(const Event& event) {
    return event.bolt >= 0 && event.kind != EventKind::Restick;
}

constexpr std::array<CurveStyle, mostCurves> styles{CurveStyle::Main, CurveStyle::Second, CurveStyle::Third,
                                                    CurveStyle::Fourth};

/// Adds a curve, broken where there is no number; its last piece bears the name.
void addCurve(ChartPanel& panel, CurveStyle style, const std::string& name, const std::vector<double>& x,
              const std::vector<double>& y) {
    ChartCurve piece{"", style, {}, {}};
    for (std::size_t i = 0; i < y.size(); ++i) {
        const bool known = std::isfinite(x[i]) && std::isfinite(y[i]);
        if (known) {
            piece.x.push_back(x[i]);
            piece.y.push_back(y[i]);
        }
        if ((!known || i + 1 == y.size()) && !piece.x.empty()) {
            panel.curves.push_back(piece);
            piece = {"", style, {}, {}};
        }
    }
    if (!panel.curves.empty() && panel.curves.back().style == style) panel.curves.back().name = name;
}

class HistoryChartBuilder {
public:
    HistoryChartBuilder(const RunSource& run, const std::vector<ReferenceTable>& references)
        : run_(run), time_(run), history_(run.history()), events_(run.events()), series_(seriesOf(run.scene())),
          placer_(references, time_, stageNames(run.scene())) {
        for (const HistoryRow& row : history_) times_.push_back(time_.at(row.stage, row.time));
    }

    HistoryCharts all() {
        const auto openings =
            std::count_if(series_.begin(), series_.end(), [](const Series& series) { return series.isOpening; });
        if (openings == 1)
            for (const Series& series : series_)
                if (series.isOpening) addOver(forces(), series);
        Chart chart = overTime();
        addMonitors(chart, series_);
        addDebonded(chart);
        addEnergies(chart);
        placer_.place(chart);
        leaveOutNothing(chart);
        finish(std::move(chart), true);
        return result("the run has no history to draw yet");
    }

    HistoryCharts of(const std::string& asked) {
        const std::size_t over = asked.find(" over ");
        const std::vector<const Series*> found = named(asked.substr(0, over));
        if (over != std::string::npos) {
            const std::vector<const Series*> x = named(asked.substr(over + 6));
            if (found.size() != 1 || x.size() != 1) return unknown(asked);
            addOver({*found.front()}, *x.front());
        } else {
            if (found.empty()) return unknown(asked);
            Chart chart = overTime();
            std::vector<Series> chosen;
            for (const Series* series : found) chosen.push_back(*series);
            addMonitors(chart, chosen);
            finish(std::move(chart));
        }
        return result("the run has no history of '" + asked + "' yet");
    }

private:
    static std::vector<std::string> stageNames(const Scene& scene) {
        std::vector<std::string> names;
        for (int stage = 0; stage < static_cast<int>(scene.stages.size()); ++stage)
            names.push_back(stageName(scene, stage));
        return names;
    }

    HistoryCharts result(const std::string& emptyBecause) {
        if (result_.charts.empty())
            result_.problem = emptyBecause;
        else
            result_.references = placer_.problems();
        return std::move(result_);
    }

    std::vector<const Series*> named(const std::string& name) const {
        std::vector<const Series*> found;
        for (const Series& series : series_)
            if (series.name == name || series.name == name + ".ux" || series.name == name + ".uy")
                found.push_back(&series);
        return found;
    }

    HistoryCharts unknown(const std::string& asked) const {
        std::string names;
        for (const Series& series : series_) names += (names.empty() ? "" : ", ") + series.name;
        return {{}, "'" + asked + "' is no monitor of the scene, nor one over another; there are: " +
                        (names.empty() ? "none" : names), {}, {}};
    }

    std::vector<Series> forces() const {
        std::vector<Series> found;
        std::copy_if(series_.begin(), series_.end(), std::back_inserter(found),
                     [](const Series& series) { return series.isForce; });
        return found;
    }

    std::vector<double> valuesOf(std::size_t column, double factor) const {
        std::vector<double> values;
        for (const HistoryRow& row : history_) values.push_back(row.values[column] * factor);
        return values;
    }

    Chart overTime() const {
        Chart chart;
        chart.xTitle = time_.title();
        chart.x = {0.0, time_.end()};
        chart.overTime = true;
        for (const StageSpan& span : time_.stages())
            if (span.from > 0.0) chart.dividers.push_back(span.from);
        for (const Event& event : events_)
            if (isOfBolts(event)) chart.events.push_back(time_.at(event.stage, event.time));
        return chart;
    }

    /// Several forces over one displacement, with the events where they happened.
    void addOver(const std::vector<Series>& of, const Series& over) {
        const std::vector<double> x = valuesOf(over.column, over.factor);
        Chart chart;
        chart.xTitle = withUnit(over);
        ValueRange range;
        for (const double value : x)
            if (std::isfinite(value)) range = {std::min(range.low, value), std::max(range.high, value)};
        chart.x = range;
        for (const Event& event : events_)
            if (isOfBolts(event) && event.historyRow >= 0 && static_cast<std::size_t>(event.historyRow) < x.size())
                chart.events.push_back(x[static_cast<std::size_t>(event.historyRow)]);
        addPanels(chart, of, x);
        finish(std::move(chart));
    }

    void addMonitors(Chart& chart, const std::vector<Series>& of) { addPanels(chart, of, times_); }

    /// A panel for each title, in the order in which they come first.
    void addPanels(Chart& chart, const std::vector<Series>& of, const std::vector<double>& x) {
        std::vector<std::string> titles;
        for (const Series& series : of)
            if (std::find(titles.begin(), titles.end(), series.title) == titles.end()) titles.push_back(series.title);
        for (const std::string& title : titles) {
            ChartPanel panel;
            std::size_t curves = 0;
            for (const Series& series : of) {
                if (series.title != title) continue;
                if (curves == mostCurves) push(chart, panel, curves);
                panel.title = title;
                addCurve(panel, styles[curves++], series.name, x, valuesOf(series.column, series.factor));
            }
            push(chart, panel, curves);
        }
    }

    static void push(Chart& chart, ChartPanel& panel, std::size_t& curves) {
        if (!panel.curves.empty()) chart.panels.push_back(panel);
        panel = {};
        curves = 0;
    }

    /// The bolts that debonded furthest.
    void addDebonded(Chart& chart) {
        std::vector<std::pair<double, Series>> bolts;
        for (std::size_t b = 0; b < run_.scene().bolts.size(); ++b) {
            const auto column = static_cast<std::size_t>(
                historyColumn(run_.scene(), {-1, 0, static_cast<int>(b), BoltQuantity::DebondedLength}));
            double most = 0.0;
            for (const HistoryRow& row : history_)
                if (std::isfinite(row.values[column])) most = std::max(most, row.values[column]);
            if (most > 0.0)
                bolts.push_back({most, {run_.scene().bolts[b].name, "Debonded length (m)", column, 1.0, false, false}});
        }
        std::stable_sort(bolts.begin(), bolts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<Series> shown;
        for (std::size_t i = 0; i < std::min(bolts.size(), mostCurves); ++i) shown.push_back(bolts[i].second);
        addPanels(chart, shown, times_);
    }

    /// The largest energies of the frames.
    void addEnergies(Chart& chart) {
        std::vector<double> x;
        for (const FrameHead& frame : run_.frames()) x.push_back(time_.at(frame.stage, frame.time));
        std::vector<std::pair<double, const FrameQuantity<Energy>*>> rows;
        double largest = 0.0;
        for (const FrameQuantity<Energy>& row : energyQuantities()) {
            if (row.display.unit.empty()) continue;
            double most = 0.0;
            for (const FrameHead& frame : run_.frames()) most = std::max(most, std::abs(row.value(frame.energy)));
            largest = std::max(largest, most);
            rows.emplace_back(most, &row);
        }
        std::erase_if(rows, [&](const auto& row) { return row.first <= negligible * largest; });
        std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        const bool small = largest < 1e3;
        ChartPanel panel;
        panel.title = small ? "Energy (J)" : "Energy (kJ)";
        panel.note = rows.size() > mostCurves ? "the four largest" : "";
        for (std::size_t i = 0; i < std::min(rows.size(), mostCurves); ++i) {
            std::vector<double> y;
            for (const FrameHead& frame : run_.frames())
                y.push_back(rows[i].second->value(frame.energy) * (small ? 1.0 : 1e-3));
            addCurve(panel, styles[i], std::string(rows[i].second->display.title), x, y);
        }
        if (!panel.curves.empty()) chart.panels.push_back(std::move(panel));
    }

    /// Events nearer to each other than a line is wide stand as one.
    static void thinEvents(Chart& chart) {
        const double least = leastBetweenEvents * (chart.x.high - chart.x.low);
        std::vector<double> kept;
        std::sort(chart.events.begin(), chart.events.end());
        for (const double place : chart.events)
            if (kept.empty() || place - kept.back() >= least) kept.push_back(place);
        chart.events = std::move(kept);
    }

    static std::string unitOf(const ChartPanel& panel) { return partedTitle(panel.title).unit; }

    static double largestOf(const ChartPanel& panel) {
        double largest = 0.0;
        for (const ChartCurve& curve : panel.curves)
            for (const double y : curve.y) largest = std::max(largest, std::abs(y));
        return largest;
    }

    /// Panels of nothing but round-off, to what others of their unit show, stand as words. Moments are judged by the
    /// forces too, at an arm of 1 m.
    void leaveOutNothing(Chart& chart) {
        std::map<std::string, double> largest;
        for (const ChartPanel& panel : chart.panels) {
            double& most = largest[unitOf(panel)];
            most = std::max(most, largestOf(panel));
        }
        largest["N m"] = std::max(largest["N m"], 1e3 * largest["kN"]);
        const auto isNothing = [&](const ChartPanel& panel) {
            return largestOf(panel) <= nothing * largest[unitOf(panel)];
        };
        if (std::all_of(chart.panels.begin(), chart.panels.end(), isNothing)) return;
        for (const ChartPanel& panel : chart.panels)
            for (const ChartCurve& curve : panel.curves)
                if (isNothing(panel) && !curve.name.empty()) result_.nothing.push_back(curve.name);
        std::erase_if(chart.panels, isNothing);
    }

    void finish(Chart chart, bool placed = false) {
        if (chart.panels.empty() || !(chart.x.low < chart.x.high)) return;
        if (!placed) placer_.place(chart);
        if (!chart.overTime) chart.x = roundedRange(chart.x, 9);
        thinEvents(chart);
        for (ChartPanel& panel : chart.panels) fitRange(panel);
        result_.charts.push_back(std::move(chart));
    }

    const RunSource& run_;
    RunTime time_;
    std::vector<HistoryRow> history_;
    std::vector<Event> events_;
    std::vector<Series> series_;
    std::vector<double> times_;  // of the history's rows
    ReferencePlacer placer_;
    HistoryCharts result_;
};

}  // namespace

HistoryCharts historyCharts(const RunSource& run, const std::optional<std::string>& asked,
                            const std::vector<ReferenceTable>& references) {
    HistoryChartBuilder builder(run, references);
    return asked ? builder.of(*asked) : builder.all();
}

}  // namespace keyblock
