// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts of a bolt and of a history, checked number by number.
#include "ui/picture/charts/bolt_chart.h"
#include "ui/picture/charts/history_charts.h"
#include "ui/picture/run_time.h"

#include "solver/results/history.h"
#include "tests/ui/bricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

using namespace test;

TEST(Chart, RangesIncludeCurvesAndNearbyLimits) {
    ChartPanel panel;
    panel.curves = {{"", CurveStyle::Main, {0, 1}, {-0.0001, 90.0}}};
    panel.limits = {{"yield", 120.0, false}, {"ultimate", 200.0, true}};
    fitRange(panel);
    ASSERT_EQ(panel.limits.size(), 1u);  // 200 is beyond 1.5 · 90
    EXPECT_EQ(panel.range, (ValueRange{0.0, 150.0}));  // −0.0001 does not extend the range
}

TEST(BoltChart, ShowsForcesOfElementsAsSteps) {
    const BricksRun bricks;
    const MemoryRun run(bricks.scene, bricks.results);
    const BoltChart chart = boltChart(run, 1, 0);
    EXPECT_DOUBLE_EQ(chart.length, 1.5);
    ASSERT_EQ(chart.chart.panels.size(), 3u);  // no shear, no moment: no panel
    const ChartPanel& axial = chart.chart.panels[0];
    const ChartCurve& curve = axial.curves.back();
    EXPECT_EQ(curve.x, (std::vector<double>{0.0, 0.5, 0.5, 1.0, 1.0, 1.5}));
    EXPECT_EQ(curve.y, (std::vector<double>{25.0, 25.0, 100.0, 100.0, 25.0, 25.0}));
    ASSERT_FALSE(axial.limits.empty());  // shown, however high
    EXPECT_EQ(axial.limits[0].name, "yield");
}

TEST(BoltChart, EnvelopesIncludeAllFramesToDate) {
    BricksRun bricks;
    std::swap(bricks.results.frames[0].bolts, bricks.results.frames[1].bolts);  // 100 kN first, then 1 kN
    const MemoryRun run(bricks.scene, bricks.results);
    const BoltChart chart = boltChart(run, 1, 0);
    ASSERT_FALSE(chart.envelopes.empty());
    const Envelope& envelope = chart.envelopes[0];
    EXPECT_EQ(envelope.quantity, "axial_force_N");
    EXPECT_DOUBLE_EQ(*std::max_element(envelope.high.begin(), envelope.high.end()), 100e3);
    EXPECT_DOUBLE_EQ(envelope.high[0], 25e3);
    EXPECT_DOUBLE_EQ(envelope.high[200], 100e3);  // halfway
    EXPECT_DOUBLE_EQ(*std::max_element(envelope.low.begin(), envelope.low.end()), 0.0);
}

/// Round-off of a bolt after failure is not a force: the range is that of its earlier forces.
TEST(BoltChart, RangesIncludeTheForcesOfBondedNodesToDate) {
    BricksRun bricks;
    for (std::size_t f : {0u, 1u})
        for (BoltNodeFrame& node : bricks.results.frames[f].bolts[0].nodes) {
            node.real = true;
            node.anchorForce = f == 0 ? -40e3 : 1e-9;
            node.axialForce *= f == 0 ? 1.0 : 1e-12;
        }
    const BoltChart chart = boltChart(MemoryRun(bricks.scene, bricks.results), 1, 0);
    const ChartPanel& bond = chart.chart.panels[1];
    EXPECT_EQ(bond.title, "Bond force (kN)");
    EXPECT_EQ(bond.range, (ValueRange{-40.0, 0.0}));
    EXPECT_NE(chart.subtitle.find("in this frame 0 kN"), std::string::npos) << chart.subtitle;
}

/// The shear force that broke a bar is shown, though none is left now.
TEST(BoltChart, PastShearForcesHaveAPanel) {
    BricksRun bricks;
    bricks.results.frames[0].bolts[0].nodes[1].shearForce = 119e3;
    const BoltChart chart = boltChart(MemoryRun(bricks.scene, bricks.results), 1, 0);
    ASSERT_EQ(chart.chart.panels.size(), 4u);
    const ChartPanel& shear = chart.chart.panels[1];
    EXPECT_EQ(shear.title, "Shear force Q (kN)");
    EXPECT_EQ(shear.range.high, 150.0);  // 119 kN at steps of 50
    ASSERT_EQ(shear.curves.size(), 2u);
    EXPECT_EQ(shear.curves[0].style, CurveStyle::Envelope);
    EXPECT_EQ(*std::max_element(shear.curves[0].y.begin(), shear.curves[0].y.end()), 119.0);
    EXPECT_EQ(*std::max_element(shear.curves[1].y.begin(), shear.curves[1].y.end()), 0.0);
}

/// With each node's current embedment, on the side of zero of the forces; a bond that softens has its residual, too.
TEST(BoltChart, BondLimitsAreDrawnNodeByNode) {
    BricksRun bricks;
    auto& nodes = bricks.results.frames[1].bolts[0].nodes;
    for (std::size_t i : {0u, 1u, 3u}) {
        nodes[i].anchorForce = 8e3;
        nodes[i].bondStrength = i == 0 ? 5e3 : 10e3;
        nodes[i].bondResidual = i == 3 ? 10e3 : 4e3;
    }
    const BoltChart chart = boltChart(MemoryRun(bricks.scene, bricks.results), 1, 0);
    const std::vector<ChartLimit>& limits = chart.chart.panels[1].limits;
    ASSERT_EQ(limits.size(), 3u);  // two pieces of the peak, one of the residual
    EXPECT_EQ(limits[0].x, (std::vector<double>{0.0, 0.25, 0.25, 0.75}));
    EXPECT_EQ(limits[0].y, (std::vector<double>{5.0, 5.0, 10.0, 10.0}));
    EXPECT_EQ(limits[0].name, "");  // the next piece is named
    EXPECT_EQ(limits[1].x, (std::vector<double>{1.25, 1.5}));
    EXPECT_EQ(limits[1].name, "peak");
    EXPECT_EQ(limits[2].y, (std::vector<double>{4.0, 4.0, 4.0, 4.0}));
    EXPECT_EQ(limits[2].name, "residual");
    for (BoltNodeFrame& node : nodes) node.anchorForce = 6e3;  // 10 is beyond 1.5 · 6
    EXPECT_EQ(boltChart(MemoryRun(bricks.scene, bricks.results), 1, 0).chart.panels[1].limits.size(), 1u);
}

TEST(BoltChart, ZonesAndJointsAreAtTheirPositions) {
    BricksRun bricks;
    auto& nodes = bricks.results.frames[1].bolts[0].nodes;
    nodes[1].state = nodes[2].state = NodeState::Slipping;
    nodes[2].block = nodes[3].block = 1;
    const BoltChart chart = boltChart(MemoryRun(bricks.scene, bricks.results), 1, 0);
    ASSERT_EQ(chart.chart.zones.size(), 1u);
    EXPECT_DOUBLE_EQ(chart.chart.zones[0].from, 0.25);
    EXPECT_DOUBLE_EQ(chart.chart.zones[0].to, 1.25);
    ASSERT_EQ(chart.chart.dividers.size(), 1u);
    EXPECT_DOUBLE_EQ(chart.chart.dividers[0], 0.75);
}

TEST(BoltChart, TheMostLoadedBoltIsFound) {
    BricksRun bricks;
    Frame& frame = bricks.results.frames[0];
    EXPECT_EQ(mostLoadedBolt(frame), 0);
    EXPECT_EQ(mostLoadedBolt(Frame{}), -1);
    frame.extremes.resize(1);
    frame.extremes[0].axialForce.value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(mostLoadedBolt(frame), 0);
}

/// Two stages with an opening, a force and a point.
struct HistoryRun : BricksRun {
    HistoryRun() {
        Stage first;
        first.name = "settle";
        scene.stages.insert(scene.stages.begin(), first);
        for (auto& event : results.events) event.stage = 1;
        for (Frame& frame : results.frames) frame.stage = 1;
        Monitor gap;
        gap.name = "gap";
        gap.between = {{Point(0.0, 1.0), Point(0.0, 1.1)}};
        Monitor force;
        force.name = "pull";
        force.bolt = "B";
        force.at = 0.7;
        Monitor point;
        point.name = "crown";
        point.point = Point(0.0, 1.0);
        scene.monitors = {gap, force, point};
        results.columns = historyColumns(scene);
        for (int i = 0; i < 4; ++i) {
            HistoryRow row;
            row.stage = i < 2 ? 0 : 1;
            row.time = i < 2 ? i : 0.05 * (i - 1);
            row.values.assign(results.columns.names.size(), 0.0);
            row.values[0] = 1e-3 * i;
            row.values[1] = i == 0 ? std::numeric_limits<double>::quiet_NaN() : 1e3 * i;
            row.values[2] = 5e-4 * i;
            row.values[3] = -2e-3 * i;
            results.history.push_back(row);
        }
        for (Event& event : results.events) event.historyRow = 2;
    }
    HistoryCharts charts(const std::optional<std::string>& asked = {}) const {
        return historyCharts(MemoryRun(scene, results), asked);
    }
};

TEST(RunTime, StagesFollowOneAnother) {
    const HistoryRun bricks;
    const RunTime time(MemoryRun(bricks.scene, bricks.results));
    ASSERT_EQ(time.stages().size(), 2u);
    EXPECT_DOUBLE_EQ(time.stages()[1].from, 1.0);
    EXPECT_DOUBLE_EQ(time.at(1, 0.2), 2.2);
    EXPECT_DOUBLE_EQ(time.end(), 4.0);  // three times the room of a static one
    EXPECT_DOUBLE_EQ(time.stages()[1].reached, 0.5);  // by the last event
    EXPECT_DOUBLE_EQ(time.atTotal(1.25), 2.5);
    EXPECT_EQ(momentAt(time.stages(), 2.2).span->stage, 1);
    EXPECT_DOUBLE_EQ(momentAt(time.stages(), 2.2).time, 0.2);
    EXPECT_EQ(momentAt(time.stages(), 0.25).span->stage, 0);
    EXPECT_DOUBLE_EQ(momentAt(time.stages(), 99.0).time, 0.5);
}

TEST(RunTime, OneStageHasItsOwnTime) {
    HistoryRun bricks;
    std::erase_if(bricks.results.history, [](const HistoryRow& row) { return row.stage == 0; });
    std::erase_if(bricks.results.frames, [](const Frame& frame) { return frame.stage == 0; });
    std::erase_if(bricks.results.events, [](const Event& event) { return event.stage == 0; });
    const RunTime time(MemoryRun(bricks.scene, bricks.results));
    ASSERT_EQ(time.stages().size(), 1u);
    EXPECT_DOUBLE_EQ(time.at(1, 0.2), 0.2);
    EXPECT_EQ(time.title(), "time (s)");
}

TEST(RunTime, EachStageHasItsOwnNumbersWithoutOverlap) {
    const std::vector<StageSpan> stages{{0, "settle", 0.0, 1.0, 1.0}, {1, "burst", 1.0, 4.0, 0.008}};
    const auto widthOf = [](const std::string& text) { return 1.2 * static_cast<double>(text.size()) + 1.0; };
    for (const double length : {20.0, 60.0, 120.0}) {
        const std::vector<AxisTick> ticks = stageTicks(stages, length / 4.0, widthOf);
        double free = -100.0;
        for (const AxisTick& tick : ticks) {
            const double half = 0.5 * widthOf(tick.text), place = tick.at * length / 4.0;
            EXPECT_GE(place - half, free - 1e-9) << tick.text << " at " << length;
            free = place + half;
        }
        EXPECT_EQ(ticks.front().at, 0.0);
        EXPECT_GT(ticks.size(), length < 30.0 ? 1u : 3u);
    }
    const std::vector<AxisTick> wide = stageTicks(stages, 30.0, widthOf);
    EXPECT_EQ(wide.back().text, "0.008");
    EXPECT_DOUBLE_EQ(wide.back().at, 4.0);
}

TEST(HistoryCharts, LoadOverDisplacementComesFirst) {
    const HistoryCharts charts = HistoryRun().charts();
    ASSERT_EQ(charts.charts.size(), 2u);
    const Chart& load = charts.charts[0];
    EXPECT_EQ(load.xTitle, "gap (mm)");
    ASSERT_EQ(load.panels.size(), 1u);
    ASSERT_EQ(load.panels[0].curves.size(), 1u);
    EXPECT_EQ(load.panels[0].curves[0].x, (std::vector<double>{1.0, 2.0, 3.0}));  // rows without a number are skipped
    EXPECT_EQ(load.panels[0].curves[0].y, (std::vector<double>{1.0, 2.0, 3.0}));
    EXPECT_EQ(load.panels[0].curves[0].name, "pull");
    EXPECT_EQ(load.events, (std::vector<double>{2.0}));  // yields and rupture at one abscissa; joint events are not marked
}

TEST(HistoryCharts, PanelsAreGroupedByQuantity) {
    const HistoryCharts charts = HistoryRun().charts();
    const Chart& time = charts.charts[1];
    std::vector<std::string> titles;
    for (const ChartPanel& panel : time.panels) titles.push_back(panel.title);
    EXPECT_EQ(titles, (std::vector<std::string>{"Opening (mm)", "Axial force (kN)", "Displacement along x (mm)",
                                                "Displacement along y (mm)"}));
    EXPECT_EQ(time.panels[3].curves[0].y.back(), -6.0);
    EXPECT_EQ(time.dividers, (std::vector<double>{1.0}));
}

TEST(HistoryCharts, ARequestedQuantityIsShownAlone) {
    const HistoryRun run;
    const HistoryCharts over = run.charts("crown.uy over gap");
    ASSERT_EQ(over.charts.size(), 1u);
    EXPECT_EQ(over.charts[0].panels[0].curves[0].y.back(), -6.0);
    EXPECT_EQ(run.charts("crown").charts[0].panels.size(), 2u);
    const HistoryCharts none = run.charts("floor");
    EXPECT_TRUE(none.charts.empty());
    EXPECT_NE(none.problem.find("gap, pull, crown.ux, crown.uy"), std::string::npos) << none.problem;
}

TEST(HistoryCharts, AnyQuantityIsPlottedAgainstAnother) {
    HistoryRun run;
    const std::size_t column = historyColumn(run.scene, {-1, 0, 0, BoltQuantity::AxialForce});
    for (std::size_t i = 0; i < run.results.history.size(); ++i)
        run.results.history[i].values[column] = 5e3 * static_cast<double>(i);
    const HistoryCharts bolt = run.charts("B.axial_force over crown.uy");
    ASSERT_EQ(bolt.charts.size(), 1u) << bolt.problem;
    EXPECT_EQ(bolt.charts[0].xTitle, "crown.uy (mm)");
    EXPECT_EQ(bolt.charts[0].panels[0].title, "Axial force (kN)");
    EXPECT_EQ(bolt.charts[0].panels[0].curves[0].y, (std::vector<double>{0.0, 5.0, 10.0, 15.0}));
    // Energies are known at frames only (0 and 0.1 s of the second stage): there the history's last row is used.
    run.results.frames[1].energy.kinetic = 7.0;
    const HistoryCharts energy = run.charts("energy.kinetic over B.axial_force");
    ASSERT_EQ(energy.charts.size(), 1u) << energy.problem;
    EXPECT_EQ(energy.charts[0].panels[0].title, "Energy (J)");
    EXPECT_EQ(energy.charts[0].panels[0].curves[0].x, (std::vector<double>{5.0, 15.0}));
    EXPECT_EQ(energy.charts[0].panels[0].curves[0].y, (std::vector<double>{0.0, 7.0}));
    EXPECT_EQ(run.charts("energy.kinetic").charts[0].overTime, true);
    EXPECT_TRUE(run.charts("B.axial_force over nothing").charts.empty());
}

/// `opening, load` in SI.
ReferenceTable labOf(const std::string& x, const std::string& y) {
    return {"lab.csv", "lab", {}, {{y + "_kN", y, Measure::Force, {0.0, 2.5e3, 5e3}},
                                   {x + "_mm", x, Measure::Length, {0.0, 2e-3, 4.5e-3}}}};
}

const ChartCurve* referenceIn(const ChartPanel& panel) {
    for (const ChartCurve& curve : panel.curves)
        if (isReference(curve.style)) return &curve;
    return nullptr;
}

TEST(References, AreDrawnWhereBothMeasuresAreShown) {
    const HistoryRun run;
    const MemoryRun source(run.scene, run.results);
    const HistoryCharts charts = historyCharts(source, {}, {labOf("opening", "load")});
    const ChartCurve* curve = referenceIn(charts.charts[0].panels[0]);
    ASSERT_TRUE(curve);
    EXPECT_EQ(curve->x, (std::vector<double>{0.0, 2.0, 4.5}));
    EXPECT_EQ(curve->y, (std::vector<double>{0.0, 2.5, 5.0}));
    EXPECT_EQ(curve->name, "lab");
    EXPECT_EQ(charts.charts[0].x.high, 5.0);  // 4.5 mm is beyond the run's 3 mm
    EXPECT_EQ(charts.charts[0].panels[0].range.high, 6.0);  // 5 kN at steps of 2, five ticks at most
    for (const ChartPanel& panel : charts.charts[1].panels) EXPECT_FALSE(referenceIn(panel));  // it has no time
    EXPECT_TRUE(charts.references.empty());
}

TEST(References, NamesDecideBetweenPanelsOfOneMeasure) {
    const HistoryRun run;
    const MemoryRun source(run.scene, run.results);
    const std::vector<double> values{1e-3, 2e-3};
    const auto overTime = [&](const std::string& name) {
        return ReferenceTable{"lab.csv", "lab", {}, {{"t_s", "t", Measure::Time, {0.0, 1.0}},
                                                     {name + "_mm", name, Measure::Length, values}}};
    };
    const HistoryCharts named = historyCharts(source, {}, {overTime("crown_uy")});
    ASSERT_TRUE(referenceIn(named.charts[1].panels[3]));
    EXPECT_EQ(referenceIn(named.charts[1].panels[3])->y, (std::vector<double>{1.0, 2.0}));
    EXPECT_FALSE(referenceIn(named.charts[1].panels[2]));
    const HistoryCharts loose = historyCharts(source, {}, {overTime("sag")});
    ASSERT_EQ(loose.references.size(), 1U);
    EXPECT_EQ(loose.references[0].severity, Severity::Error);
    EXPECT_NE(loose.references[0].message.find("'sag_mm' (length)"), std::string::npos);
    EXPECT_NE(loose.references[0].remedy.find("Displacement along y (mm) over time of each stage"), std::string::npos)
        << loose.references[0].remedy;
    EXPECT_TRUE(historyCharts(source, "crown.uy", {overTime("sag")}).references.empty());  // one panel: no doubt
}

TEST(References, StageTimesArePlottedWithinTheStage) {
    const HistoryRun run;
    const MemoryRun source(run.scene, run.results);
    ReferenceTable table{"lab.csv", "lab", {"settle", run.scene.stages[1].name},
                         {{"time_s", "time", Measure::Time, {0.5, 0.25}}, {"pull_N", "pull", Measure::Force, {1e3, 2e3}}}};
    const HistoryCharts charts = historyCharts(source, "pull", {table});
    EXPECT_EQ(referenceIn(charts.charts[0].panels[0])->x, (std::vector<double>{0.5, 2.5}));
    table.stages[0] = "setle";
    const HistoryCharts wrong = historyCharts(source, "pull", {table});
    EXPECT_EQ(referenceIn(wrong.charts[0].panels[0])->x, (std::vector<double>{2.5}));
}

TEST(References, UnmatchedColumnsAreReported) {
    const HistoryRun run;
    ReferenceTable table = labOf("gap", "pull");
    table.columns.push_back({"work_J", "work", Measure::Energy, {0.0, 1.0, 2.0}});
    const HistoryCharts charts = historyCharts(MemoryRun(run.scene, run.results), "pull over gap", {table});
    ASSERT_EQ(charts.references.size(), 1U);
    EXPECT_EQ(charts.references[0].severity, Severity::Warning);
    EXPECT_NE(charts.references[0].message.find("'work_J' (energy)"), std::string::npos);
}

TEST(References, WithoutAColumnForAnAxisNothingIsDrawn) {
    const HistoryRun run;
    const HistoryCharts charts = historyCharts(MemoryRun(run.scene, run.results), "pull", {labOf("gap", "pull")});
    ASSERT_EQ(charts.references.size(), 1U);
    EXPECT_EQ(charts.references[0].severity, Severity::Error);
    EXPECT_NE(charts.references[0].message.find("no column for an axis"), std::string::npos);
    EXPECT_FALSE(referenceIn(charts.charts[0].panels[0]));
}

TEST(References, TwoCurvesOfAFileAreNamedByTheirColumns) {
    const HistoryRun run;
    ReferenceTable table = labOf("gap", "dry");
    table.columns.push_back({"wet_kN", "wet", Measure::Force, {0.0, 1e3, 2e3}});
    const auto charts = historyCharts(MemoryRun(run.scene, run.results), "pull over gap", {table, labOf("gap", "old")});
    const std::vector<ChartCurve>& curves = charts.charts[0].panels[0].curves;
    ASSERT_EQ(curves.size(), 4U);
    EXPECT_EQ(curves[1].name, "lab: dry");
    EXPECT_EQ(curves[2].name, "lab: wet");
    EXPECT_EQ(curves[3].name, "lab");
    EXPECT_NE(curves[1].style, curves[2].style);
    EXPECT_NE(curves[2].style, curves[3].style);
}

/// 4e-7 mm compared with 3 mm is round-off of the equations, not a movement.
TEST(HistoryCharts, RoundOffHasNoPanel) {
    HistoryRun run;
    for (HistoryRow& row : run.results.history) row.values[2] = 1e-10 * row.time, row.values[3] = -1e-3 * row.time;
    const HistoryCharts charts = run.charts();
    for (const ChartPanel& panel : charts.charts[1].panels) EXPECT_NE(panel.title, "Displacement along x (mm)");
    EXPECT_EQ(charts.nothing, (std::vector<std::string>{"crown.ux"}));
    EXPECT_EQ(run.charts("crown.ux").charts[0].panels.size(), 1U);  // shown on request
}

TEST(HistoryCharts, ARunWithoutHistoryIsReported) {
    HistoryRun run;
    run.results.history.clear();
    run.results.frames.clear();
    EXPECT_FALSE(run.charts().problem.empty());
}

}  // namespace
}  // namespace keyblock
