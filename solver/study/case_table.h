// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// cases.csv: one row for each case, with its number and the value of each parameter. A
// case finds its row by bisection, so that it reads a few kilobytes of any plan.
#pragma once

#include "solver/study/case_plan.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

/// Text of the whole table.
std::string caseTable(const Study& study, const CasePlan& plan);

/// Cells of a row of CSV without line feeds in its cells.
std::vector<std::string> cellsOf(const std::string& line);

/// Cells of the parameters of a case, counted from 1.
/// \throws CannotRead if the table cannot be read or lacks the case.
std::vector<std::string> readCaseRow(const std::filesystem::path& table, long number, std::size_t parameters);

}  // namespace keyblock
