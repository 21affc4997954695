// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// CSV as spreadsheets of many countries write it: separated by commas, semicolons
// or tabs, with quotes, with or without a byte-order mark. Every cell knows its
// line and column.
#pragma once

#include "solver/scene/problem.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

struct CsvCell {
    std::string text;  // UTF-8, without blanks around it
    int line = 0;  // where it begins, from 1
    bool quoted = false;
};

using CsvRow = std::vector<CsvCell>;

struct CsvRows {
    std::vector<CsvRow> rows;  // without empty ones and comments (`#`)
    char separator = ',';
    std::vector<Problem> problems;
};

/// Splits a text into rows of cells. The first row says by what cells are separated: tabs, else semicolons, else
/// commas.
CsvRows readCsvRows(std::string_view text);

}  // namespace keyblock
