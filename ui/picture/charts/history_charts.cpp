// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/history_charts.h"

#include "solver/results/frame_quantities.h"
#include "solver/results/history.h"
#include "solver/results/result_names.h"
#include "ui/picture/charts/history_series.h"
#include "ui/picture/charts/reference_curves.h"
#include "ui/picture/charts/series_chart.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace keyblock {

namespace {

constexpr double negligibleEnergy = 1e-3;  // energies below this share of the largest are not shown
constexpr double noCurve = 1e-5;  // fraction of the largest value of the same unit; smaller curves are round-off

class HistoryChartBuilder {
public:
    HistoryChartBuilder(const RunSource& run, const std::vector<ReferenceTable>& references)
        : run_(run), time_(run), history_(run.history()), events_(run.events()), series_(monitorSeries(run.scene())),
          placer_(references, time_, stageNames(run.scene())) {
        for (const HistoryRow& row : history_) times_.push_back(time_.at(row.stage, row.time));
        for (const FrameHead& frame : run_.frames()) frameTimes_.push_back(time_.at(frame.stage, frame.time));
    }

    HistoryCharts all() {
        const auto openings =
            std::count_if(series_.begin(), series_.end(), [](const Series& series) { return series.isOpening; });
        if (openings == 1)
            for (const Series& series : series_)
                if (series.isOpening) addOver(forces(), series);
        Chart chart = chartOverTime(time_, events_);
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
        const std::vector<Series> found = named(asked.substr(0, over));
        if (over != std::string::npos) {
            const std::vector<Series> x = named(asked.substr(over + 6));
            if (found.size() != 1 || x.size() != 1) return unknown(asked);
            addOver(found, x.front());
        } else {
            if (found.empty()) return unknown(asked);
            Chart chart = chartOverTime(time_, events_);
            addMonitors(chart, found);
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

    /// The series of a monitor with that name, or else another series of the run.
    std::vector<Series> named(const std::string& name) const {
        std::vector<Series> found;
        for (const Series& series : series_)
            if (series.name == name || series.name == name + ".ux" || series.name == name + ".uy")
                found.push_back(series);
        if (found.empty())
            for (const Series& series : allSeries(run_))
                if (series.name == name) found.push_back(series);
        return found;
    }

    HistoryCharts unknown(const std::string& asked) const {
        std::string names;
        for (const Series& series : series_) names += (names.empty() ? "" : ", ") + series.name;
        return {{}, "'" + asked + "' is not a monitor of the scene, nor one monitor over another; monitors: " +
                        (names.empty() ? "none" : names) +
                        "; also the quantities of every bolt, such as BOLT.axial_force, and energies, such as energy.kinetic", {}, {}};
    }

    std::vector<Series> forces() const {
        std::vector<Series> found;
        std::copy_if(series_.begin(), series_.end(), std::back_inserter(found),
                     [](const Series& series) { return series.isForce; });
        return found;
    }

    static bool isOfFrames(const std::vector<Series>& some) {
        return std::any_of(some.begin(), some.end(), [](const Series& series) { return series.energy; });
    }

    std::vector<double> valuesAt(const Series& series, bool atFrames) const {
        return atFrames ? valuesOf(series, history_, run_.frames()) : valuesOf(series, history_);
    }

    /// Index of the row of the history, or of the frame, before an event; −1: none.
    long placeOf(const Event& event, bool atFrames) const {
        if (!atFrames) return event.historyRow;
        const auto& frames = run_.frames();
        const auto after = std::upper_bound(frames.begin(), frames.end(), event, [](const Event& e, const FrameHead& f) {
            return std::pair(e.stage, e.time) < std::pair(f.stage, f.time);
        });
        return after - frames.begin() - 1;
    }

    /// Plots several series against another one, with the events. If a series is known only at frames, the points are
    /// those of the frames.
    void addOver(const std::vector<Series>& of, const Series& over) {
        const bool atFrames = over.energy || isOfFrames(of);
        const std::vector<double> x = valuesAt(over, atFrames);
        Chart chart;
        chart.xTitle = withUnit(over);
        ValueRange range;
        for (const double value : x)
            if (canBeShown(value)) range = {std::min(range.low, value), std::max(range.high, value)};
        chart.x = range;
        for (const Event& event : events_) {
            const long place = placeOf(event, atFrames);
            const std::size_t at = place;
            if (isOfBolts(event) && place >= 0 && at < x.size() && canBeShown(x[at])) chart.events.push_back(x[at]);
        }
        addPanels(chart, of, x, atFrames);
        finish(std::move(chart));
    }

    void addMonitors(Chart& chart, const std::vector<Series>& of) {
        addPanels(chart, of, isOfFrames(of) ? frameTimes_ : times_, isOfFrames(of));
    }

    /// Adds a panel for each title, in order of first occurrence.
    void addPanels(Chart& chart, const std::vector<Series>& of, const std::vector<double>& x, bool atFrames = false) {
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
                addCurve(panel, curveStyles[curves++], series.name, x, valuesAt(series, atFrames));
            }
            push(chart, panel, curves);
        }
    }

    static void push(Chart& chart, ChartPanel& panel, std::size_t& curves) {
        if (!panel.curves.empty()) chart.panels.push_back(panel);
        panel = {};
        curves = 0;
    }

    /// Adds the debonded lengths of the bolts that have debonded most.
    void addDebonded(Chart& chart) {
        const BoltQuantityRow& debonded = rowOf(BoltQuantity::DebondedLength);
        std::vector<std::pair<double, Series>> bolts;
        for (std::size_t b = 0; b < run_.scene().bolts.size(); ++b) {
            const std::size_t column = 
                historyColumn(run_.scene(), {-1, 0, static_cast<int>(b), debonded.quantity});
            double most = 0.0;
            for (const HistoryRow& row : history_)
                if (canBeShown(row.values[column])) most = std::max(most, row.values[column]);
            if (most > 0.0)
                bolts.push_back({most, {run_.scene().bolts[b].name, titleWithUnit(debonded), column, debonded.factor,
                                        false, false}});
        }
        std::stable_sort(bolts.begin(), bolts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        std::vector<Series> shown;
        for (std::size_t i = 0; i < std::min(bolts.size(), mostCurves); ++i) shown.push_back(bolts[i].second);
        addPanels(chart, shown, times_);
    }

    /// Adds the largest of the energies stored with the frames.
    void addEnergies(Chart& chart) {
        std::vector<std::pair<double, const FrameQuantity<Energy>*>> rows;
        double largest = 0.0;
        for (const FrameQuantity<Energy>& row : energyQuantities()) {
            if (row.display.unit.empty()) continue;
            double most = 0.0;
            for (const FrameHead& frame : run_.frames())
                if (const double value = row.value(frame.energy); canBeShown(value))
                    most = std::max(most, std::abs(value));
            largest = std::max(largest, most);
            rows.emplace_back(most, &row);
        }
        std::erase_if(rows, [&](const auto& row) { return row.first <= negligibleEnergy * largest; });
        std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        const EnergyAxis axis = energyAxis(largest);
        ChartPanel panel;
        panel.title = axis.title;
        panel.note = rows.size() > mostCurves ? "the four largest" : "";
        for (std::size_t i = 0; i < std::min(rows.size(), mostCurves); ++i) {
            std::vector<double> y;
            for (const FrameHead& frame : run_.frames()) y.push_back(rows[i].second->value(frame.energy) * axis.factor);
            addCurve(panel, curveStyles[i], std::string(rows[i].second->display.title), frameTimes_, y);
        }
        if (!panel.curves.empty()) chart.panels.push_back(std::move(panel));
    }

    static std::string unitOf(const ChartPanel& panel) { return partedTitle(panel.title).unit; }

    static double largestOf(const ChartPanel& panel) {
        double largest = 0.0;
        for (const ChartCurve& curve : panel.curves)
            for (const double y : curve.y) largest = std::max(largest, std::abs(y));
        return largest;
    }

    /// Replaces panels that contain only round-off with a note. Values are compared with those of other panels with the
    /// same unit, and moments also with the forces times an arm of 1 m.
    void leaveOutNothing(Chart& chart) {
        std::map<std::string, double> largest;
        for (const ChartPanel& panel : chart.panels) {
            double& most = largest[unitOf(panel)];
            most = std::max(most, largestOf(panel));
        }
        largest["kN m"] = std::max(largest["kN m"], largest["kN"]);
        const auto isNothing = [&](const ChartPanel& panel) {
            return largestOf(panel) <= noCurve * largest[unitOf(panel)];
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
        if (finishChart(chart)) result_.charts.push_back(std::move(chart));
    }

    const RunSource& run_;
    RunTime time_;
    std::vector<HistoryRow> history_;
    std::vector<Event> events_;
    std::vector<Series> series_;
    std::vector<double> times_, frameTimes_;  // times of the history's rows and of the frames
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
