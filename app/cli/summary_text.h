// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Summary of a run: stages, events by kind, solver diagnostics, and the numbers
// that the scene requests next to those it expects. `run` ends with it, `info`
// begins with it.
#pragma once

#include "solver/results/run_source.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::cli {

/// Solver diagnostics over all stages that ended.
struct RunHealth {
    double passesMean = 0.0;  // a step
    double workMean = 0.0, factorizationsMean = 0.0, fullFactorizationsMean = 0.0;  // a solved step
    long stepCuts = 0;
    long energyCuts = 0;
    double maxPenetrationRatio = 0.0;
    double balanceError = 0.0;
    double residual = 0.0;
};

/// Null when no stage has ended.
std::optional<RunHealth> healthOf(const std::vector<StageRecord>& records);

/// The whole summary. `stageSeconds` [s of wall clock, by stage] adds a column; empty leaves it out.
std::string summaryOf(const RunSource& run, const std::map<int, double>& stageSeconds);

}  // namespace keyblock::cli
