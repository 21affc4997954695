// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which panel a measured or published curve belongs to. Names decide first, then
// the kind of measure where one panel alone shows it; what fits nowhere, or fits in
// two places, is told and never guessed at.
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
    /// All are held by reference. `stages` are the run's, by name.
    ReferencePlacer(const std::vector<ReferenceTable>& tables, const RunTime& time, std::vector<std::string> stages);

    /// Adds the curves of which the chart shows both measures, and widens its range of abscissas for them.
    void place(Chart& chart);

    /// Warnings on columns that no chart took; errors on tables of which none was taken.
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
    std::vector<std::string> faults_;  // by table: why it stands on no axis
    std::vector<std::string> seen_;  // panels over their axes, for people
};

}  // namespace keyblock
