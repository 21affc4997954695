// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities that vary over a run: monitor readings, largest forces of each bolt,
// energies. Each of them can be plotted on either axis of a chart.
#pragma once

#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock {

struct Series {
    std::string name;  // used in requests
    std::string title;  // title of its panel, with the unit
    std::size_t column = 0;  // column of the history table
    double factor = 1.0;  // from SI to the display unit
    bool isForce = false, isOpening = false;
    const FrameQuantity<Energy>* energy = nullptr;  // if not null, values are taken from the frames instead of a column
};

/// Series of all monitors of the scene. A monitored point NAME gives two series, NAME.ux and NAME.uy; any other monitor
/// gives one series with its own name.
std::vector<Series> monitorSeries(const Scene& scene);

/// All series of a run: first those of the monitors, then those of each bolt (named BOLT.QUANTITY), then the energies
/// (named energy.NAME).
std::vector<Series> allSeries(const RunSource& run);

/// One value per row of the history or, if frames are given, per frame, in the display unit. The value at a frame is
/// taken from the last history row that is not later than the frame; it is NaN if there is no such row. Energies are
/// taken from the frames themselves.
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows);
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows,
                             const std::vector<FrameHead>& frames);

/// Axis title: NAME (unit).
std::string withUnit(const Series& series);

/// Axis title and conversion factor for energies.
struct EnergyAxis {
    const char* title;
    double factor;  // from joules to the display unit
};

/// Axis for energies of at most `largest` [J]: in joules if `largest` is less than 1 kJ, otherwise in kilojoules.
EnergyAxis energyAxis(double largest);

}  // namespace keyblock
