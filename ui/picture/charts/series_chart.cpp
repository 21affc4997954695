// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/series_chart.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {

namespace {

constexpr double leastBetweenEvents = 0.005;  // fraction of the chart's width

/// Events closer together than a line width are drawn as one.
void thinEvents(Chart& chart) {
    const double least = leastBetweenEvents * (chart.x.high - chart.x.low);
    std::vector<double> kept;
    std::erase_if(chart.events, [](double place) { return !canBeShown(place); });
    std::sort(chart.events.begin(), chart.events.end());
    for (const double place : chart.events)
        if (kept.empty() || place - kept.back() >= least) kept.push_back(place);
    chart.events = std::move(kept);
}

}  // namespace

bool isOfBolts(const Event& event) { return event.bolt >= 0 && !isMinor(event.kind); }

Chart chartOverTime(const RunTime& time, const std::vector<Event>& events) {
    Chart chart;
    chart.xTitle = time.title();
    chart.x = {0.0, time.end()};
    chart.overTime = true;
    chart.stages = time.stages();
    for (const StageSpan& span : time.stages())
        if (span.from > 0.0) chart.dividers.push_back(span.from);
    for (const Event& event : events)
        if (isOfBolts(event)) chart.events.push_back(time.at(event.stage, event.time));
    return chart;
}

void addCurve(ChartPanel& panel, CurveStyle style, const std::string& name, const std::vector<double>& x,
              const std::vector<double>& y) {
    ChartCurve piece{"", style, {}, {}};
    for (std::size_t i = 0; i < y.size(); ++i) {
        const bool known = canBeShown(x[i]) && canBeShown(y[i]);
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

bool finishChart(Chart& chart) {
    if (chart.panels.empty() || !(chart.x.low < chart.x.high)) return false;
    if (!canBeShown(chart.x.low) || !canBeShown(chart.x.high)) return false;
    if (!chart.overTime) chart.x = roundedRange(chart.x, 9);
    thinEvents(chart);
    for (ChartPanel& panel : chart.panels) fitRange(panel);
    return true;
}

}  // namespace keyblock
