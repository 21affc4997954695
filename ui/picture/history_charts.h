// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run's history tells as curves: load over displacement, what the monitors
// saw, how far bolts debonded, where the energy went; with the events of bolts.
#pragma once

#include "solver/results/reference_table.h"
#include "solver/results/run_source.h"
#include "solver/scene/problem.h"
#include "ui/picture/chart.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct HistoryCharts {
    std::vector<Chart> charts;  // one below the other, each with an axis of its own
    std::string problem;  // why there are none: what was asked for, and what there is
    std::vector<std::string> nothing;  // curves that stay next to zero all the time and are not drawn
    std::vector<Problem> references;  // what of the references no panel shows; an error: nothing of one
};

/// Of what was asked for: a monitor's name, NAME.ux, NAME.uy, any other of `allSeries`, or `Y over X`; else of all that
/// the run has. A panel shows four curves at most, further ones stand in a panel below. Beside them stand the curves of
/// `references`.
HistoryCharts historyCharts(const RunSource& run, const std::optional<std::string>& asked,
                            const std::vector<ReferenceTable>& references = {});

}  // namespace keyblock
