// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of a sweep as columns, with their statistics, and the tables made of them.
// The tables hold no time, host or path except for timing.csv.
#pragma once

#include "solver/study/case_result.h"
#include "solver/study/statistics.h"
#include "solver/study/sweep_folder.h"

#include <ostream>
#include <string>
#include <vector>

namespace keyblock {

enum class ColumnRole { Parameter, Fault, Verdict, Result };

/// One number for each case; not a number where a case has none.
struct SweepColumn {
    std::string name;
    ColumnRole role = ColumnRole::Result;
    std::vector<double> values;
};

/// Two columns of the results, one against the other.
struct ColumnPair {
    const SweepColumn *x = nullptr, *y = nullptr;
};

struct SweepResults {
    std::vector<std::string> parameters;  // names
    std::vector<std::vector<std::string>> cells;  // of the parameters, by case
    std::vector<std::optional<SweepCaseResult>> cases;  // none: not finished
    std::vector<std::string> quantities;
    std::vector<std::string> titles;  // columns of the quantities, with SI units
    std::vector<SweepColumn> columns;  // parameters and faults first
    std::string criterion;  // of failure; empty: none
    bool hasSafety = false;

    long finished() const;
};

/// How often the criterion of failure is met.
struct FailureShare {
    long decided = 0, fails = 0, undecided = 0;  // finished cases
    double probability = 0.0;
    ChanceInterval interval;  // 95 %
};

struct ConvergencePoint {
    long cases = 0;  // decided ones so far, in order of their numbers
    double probability = 0.0;
    ChanceInterval interval;
};

/// A quantity as a column of a table: its text, and the SI unit where it has one. \param scene as solved
std::string columnTitle(const std::string& quantity, const Scene& scene);

/// Reads the results of all cases. \throws CannotRead if a file is damaged, or cases.csv is not the planned one
SweepResults collectResults(const Sweep& sweep, const std::vector<std::string>& quantities);

/// The same without the results of cases: none has finished.
SweepResults plannedResults(const Sweep& sweep, const std::vector<std::string>& quantities);

/// Reads the result of a case, counted from 1, if it has finished; `makeColumns` makes the columns again afterwards.
/// \return whether it has. \throws CannotRead if its file is damaged
bool readCaseInto(SweepResults& results, const Sweep& sweep, long number);

/// Makes all columns from the cells and the cases.
void makeColumns(SweepResults& results, const Study& study);

FailureShare failureShare(const SweepResults& results);

/// The probability of failure after more and more cases, at no more than a thousand points.
std::vector<ConvergencePoint> convergence(const SweepResults& results);

/// The column with this name; null if there is none.
const SweepColumn* findColumn(const SweepResults& results, std::string_view name);

/// Finite values of a column, sorted.
std::vector<double> sortedValues(const SweepColumn& column);

/// Rank correlation of a result with a parameter or fault, over the cases that have both.
double correlationOf(const SweepColumn& input, const SweepColumn& result);

void writeResultsTable(const SweepResults& results, const Study& study, std::ostream& out);
void writeTimingTable(const SweepResults& results, std::ostream& out);
void writeStatisticsTable(const SweepResults& results, std::ostream& out);
void writeCorrelationsTable(const SweepResults& results, std::ostream& out);
void writeConvergenceTable(const SweepResults& results, std::ostream& out);

/// Writes all tables and sweep.json into the folder of the sweep. \throws CannotWrite
void writeSweepTables(const SweepResults& results, const Sweep& sweep);

/// sweep.json: the numbers of cases, the probability of failure and the statistics of each column.
std::string sweepSummaryText(const SweepResults& results);

}  // namespace keyblock
