// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common parts of charts of quantities over time, or against each other.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"
#include "ui/picture/run_time.h"

#include <array>
#include <string>
#include <vector>

namespace keyblock {

inline constexpr std::size_t mostCurves = 4;  // of a panel
inline constexpr std::array<CurveStyle, mostCurves> curveStyles{CurveStyle::Main, CurveStyle::Second,
                                                                CurveStyle::Third, CurveStyle::Fourth};

/// Whether an event belongs to a bolt, and so is marked on charts.
bool isOfBolts(const Event& event);

/// Without panels yet: the run's time, its stages and the events of bolts.
Chart chartOverTime(const RunTime& time, const std::vector<Event>& events);

/// Adds a curve, split where values are missing; its last piece has the name.
void addCurve(ChartPanel& panel, CurveStyle style, const std::string& name, const std::vector<double>& x,
              const std::vector<double>& y);

/// Sets ranges, and merges events that are too close together; false if there is nothing to draw.
bool finishChart(Chart& chart);

}  // namespace keyblock
