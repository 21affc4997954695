// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curves of a run's history: load over displacement, monitors, debonded lengths,
// energies; with the events of bolts.
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
    std::string problem;  // why there are none: the request, and the available names
    std::vector<std::string> nothing;  // curves that are close to zero throughout and not drawn
    std::vector<Problem> references;  // reference columns that no panel shows; an error: none of a table
};

/// Of the requested series: a monitor's name, NAME.ux, NAME.uy, any other of `allSeries`, or `Y over X`; else of the
/// whole run. A panel shows four curves at most, further ones are in a panel below. The curves of `references` are
/// added.
HistoryCharts historyCharts(const RunSource& run, const std::optional<std::string>& asked,
                            const std::vector<ReferenceTable>& references = {});

}  // namespace keyblock
