// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Summary of a run: stages, events by kind, solver diagnostics, and the quantities
// requested by the scene compared with their expected values. `run` prints it at the
// end, `info` at the beginning.
#pragma once

#include "solver/results/run_source.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::cli {

/// Solver diagnostics of all stages that have ended.
struct RunHealth {
    double passesMean = 0.0;  // iterations per step
    std::optional<double> awakeMean;  // share of the blocks awake in dynamic steps; null: no such step
    double workMean = 0.0, factorizationsMean = 0.0, fullFactorizationsMean = 0.0;  // per solved step
    long stepCuts = 0;
    long energyCuts = 0;
    double maxPenetrationRatio = 0.0;
    double balanceError = 0.0;
    double residual = 0.0;
};

/// Solver diagnostics of a run; none if no stage has ended.
std::optional<RunHealth> healthOf(const std::vector<StageRecord>& records);

/// The complete summary of a run.
/// \param stageSeconds wall-clock time [s] of each stage, by index of the stage, for an extra column. If the map is
/// empty, the column is omitted.
std::string summaryOf(const RunSource& run, const std::map<int, double>& stageSeconds);

}  // namespace keyblock::cli
