// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts that charts of numbers over time, or over one another, are made of.
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

/// Whether an event is one of bolts, and so has a mark on charts.
bool isOfBolts(const Event& event);

/// Without panels yet: the run's time, its stages and the events of bolts.
Chart chartOverTime(const RunTime& time, const std::vector<Event>& events);

/// Adds a curve, broken where there is no number; its last piece bears the name.
void addCurve(ChartPanel& panel, CurveStyle style, const std::string& name, const std::vector<double>& x,
              const std::vector<double>& y);

/// Ranges, and events as far apart as they can be told; false where nothing is left to draw.
bool finishChart(Chart& chart);

}  // namespace keyblock
