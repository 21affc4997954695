// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantities of a run over time: monitors, largest forces of each bolt, energies. Any
// of them can be on either axis of a chart.
#pragma once

#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock {

struct Series {
    std::string name;  // name used in requests
    std::string title;  // of its panel, with the unit
    std::size_t column = 0;  // of the history
    double factor = 1.0;  // to the unit shown
    bool isForce = false, isOpening = false;
    const FrameQuantity<Energy>* energy = nullptr;  // of the frames, instead of a column
};

/// Series of the scene's monitors: NAME, for a point NAME.ux and NAME.uy.
std::vector<Series> monitorSeries(const Scene& scene);

/// Those, then BOLT.QUANTITY of every bolt, then energy.NAME.
std::vector<Series> allSeries(const RunSource& run);

/// Values at the rows of the history, or at the frames: there, of the last row that is not later.
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows);
std::vector<double> valuesOf(const Series& series, const std::vector<HistoryRow>& rows,
                             const std::vector<FrameHead>& frames);

/// NAME (unit), for an axis.
std::string withUnit(const Series& series);

/// Whether all energies of the frames are below a kilojoule, so that they are shown in joules.
bool hasSmallEnergies(const std::vector<FrameHead>& frames);

}  // namespace keyblock
