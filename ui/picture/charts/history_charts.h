// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Charts of a run's history: load against displacement, monitors, debonded lengths and
// energies, with the events of bolts.
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
    std::vector<Chart> charts;  // drawn one below the other, each with its own horizontal axis
    std::string problem;  // why there are no charts: names the request and the available series
    std::vector<std::string> nothing;  // names of curves that are omitted because they are close to zero throughout
    std::vector<Problem> references;  // columns that no panel shows; an error if a table has no others
};

/// Charts of the series that `asked` names. If `asked` is null, the default charts of the run: monitors, debonded
/// lengths and energies. A panel shows at most four curves; further curves are shown in additional panels below.
/// \param asked name of a monitor, any name from `allSeries`, or two such names as `Y over X`, which plots Y against X.
/// \param references measured or published curves, which are added to the matching panels.
HistoryCharts historyCharts(const RunSource& run, const std::optional<std::string>& asked,
                            const std::vector<ReferenceTable>& references = {});

}  // namespace keyblock
