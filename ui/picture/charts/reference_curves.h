// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Assigns measured or published curves to the panels of a chart. A column is matched by
// name first, then by its physical quantity if only one panel shows that quantity. A
// column that matches no panel, or more than one, is reported.
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
    /// `tables` and `time` are kept by reference and must outlive this object. \param stages names of the run's stages,
    /// in order.
    ReferencePlacer(const std::vector<ReferenceTable>& tables, const RunTime& time, std::vector<std::string> stages);

    /// Adds the reference curves that match the abscissa and ordinate of the chart, and extends the horizontal axis to
    /// include them.
    void place(Chart& chart);

    /// One problem for each table with columns that no panel shows: an error if no panel shows any of its columns,
    /// otherwise a warning.
    std::vector<Problem> problems() const;

private:
    std::vector<double> abscissas(std::size_t table, const Chart& chart, int& column);
    void placeColumn(std::size_t table, std::size_t column, const std::vector<double>& x, Chart& chart);
    ChartPanel* panelFor(const ReferenceColumn& column, Chart& chart) const;

    const std::vector<ReferenceTable>& tables_;
    const RunTime& time_;
    std::vector<std::string> stages_;
    std::vector<std::vector<bool>> used_;  // by table and column: has been drawn
    std::vector<bool> hasAxis_;  // by table: has a column for the horizontal axis of some chart
    std::vector<std::string> faults_;  // by table: why it could not be drawn
    std::vector<std::string> seen_;  // panels and their axes, listed in messages
};

}  // namespace keyblock
