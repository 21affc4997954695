// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assigns measured or published curves to panels. Names decide first, then the measure
// if only one panel shows it; columns that match no panel, or two, are reported, not
// guessed.
#pragma once

#include "solver/results/reference_table.h"
#include "solver/scene/problem.h"
#include "ui/picture/chart.h"
#include "ui/picture/run_time.h"

#include <string>
#include <vector>

namespace keyblock {

class ReferencePlacer {
public:
    /// All are kept by reference. `stages` are the run's, by name.
    ReferencePlacer(const std::vector<ReferenceTable>& tables, const RunTime& time, std::vector<std::string> stages);

    /// Adds the curves of which the chart shows both measures, and extends its range of abscissas for them.
    void place(Chart& chart);

    /// Warnings on columns that no chart matched; errors on tables without any match.
    std::vector<Problem> problems() const;

private:
    std::vector<double> abscissas(std::size_t table, const Chart& chart, int& column);
    void placeColumn(std::size_t table, std::size_t column, const std::vector<double>& x, Chart& chart);
    ChartPanel* panelFor(const ReferenceColumn& column, Chart& chart) const;

    const std::vector<ReferenceTable>& tables_;
    const RunTime& time_;
    std::vector<std::string> stages_;
    std::vector<std::vector<bool>> used_;  // by table and column
    std::vector<bool> hasAxis_;  // by table: of some chart
    std::vector<std::string> faults_;  // by table: why it has no axis
    std::vector<std::string> seen_;  // panels and their axes, for messages
};

}  // namespace keyblock
