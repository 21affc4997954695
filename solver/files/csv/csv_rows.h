// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads CSV as written by spreadsheets in many countries: separated by commas,
// semicolons or tabs, with quotes, with or without a byte-order mark. Every cell
// stores its line for messages.
#pragma once

#include "solver/scene/problem.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct CsvCell {
    std::string text;  // UTF-8, without surrounding blanks
    int line = 0;  // line on which the cell begins, from 1
    bool quoted = false;
};

using CsvRow = std::vector<CsvCell>;

struct CsvRows {
    std::vector<CsvRow> rows;  // without empty rows and comments (`#`)
    char separator = ',';
    std::vector<Problem> problems;
};

/// Maximum number of cells of one file; more is an error, and the rest of the file is not read.
inline constexpr std::size_t mostCsvCells = 5'000'000;

/// Splits the text of a file into rows of cells. The separator is determined from the first row: a tab if the row
/// contains one; otherwise a semicolon if the row contains one; otherwise a comma.
CsvRows readCsvRows(std::string_view text);

}  // namespace keyblock
