// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common parts of charts that show quantities over time or against each other.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"
#include "ui/picture/run_time.h"

#include <array>
#include <string>
#include <vector>

namespace keyblock {

inline constexpr std::size_t mostCurves = 4;  // curves per panel
inline constexpr std::array<CurveStyle, mostCurves> curveStyles{CurveStyle::Main, CurveStyle::Second,
                                                                CurveStyle::Third, CurveStyle::Fourth};

/// True if an event concerns a bolt and is important enough to be marked on charts.
bool isOfBolts(const Event& event);

/// A chart without panels: it has only the time axis of the run, the stages, and the events of bolts.
Chart chartOverTime(const RunTime& time, const std::vector<Event>& events);

/// Adds a curve to a panel, split into pieces at missing (non-finite) values. Only the last piece carries the name.
void addCurve(ChartPanel& panel, CurveStyle style, const std::string& name, const std::vector<double>& x,
              const std::vector<double>& y);

/// Completes a chart: sets the ranges of its panels, and merges events that are too close together to be drawn
/// separately. Returns false if the chart has nothing to show.
bool finishChart(Chart& chart);

}  // namespace keyblock
