// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What of a run is a number over time, as people see it: monitors, what each bolt
// bears at most, energies. Any of them can stand on either axis of a chart.
#pragma once

#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock {

struct Series {
    std::string name;  // as it is asked for
    std::string title;  // of its panel, with the unit
    std::size_t column = 0;  // of the history
    double factor = 1.0;  // to the unit shown
    bool isForce = false, isOpening = false;
    const FrameQuantity<Energy>* energy = nullptr;  // of the frames, in place of a column
};

/// Of the scene's monitors: NAME, of a point NAME.ux and NAME.uy.
std::vector<Series> monitorSeries(const Scene& scene);

/// Those, then BOLT.QUANTITY of every bolt, then energy.NAME.
std::vector<Series> allSeries(const RunSource& run);

/// Values at the rows of the history, or at the frames: there, of the last row that is not later.
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows);
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows,
                             const std::vector<FrameHead>& frames);

/// NAME (unit), for an axis.
std::string withUnit(const Series& series);

/// Whether energies below a kilojoule are all that the frames have, so that they are told in joules.
bool hasSmallEnergies(const std::vector<FrameHead>& frames);

}  // namespace keyblock
