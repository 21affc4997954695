// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A comma between digits is a decimal comma where commas do not separate cells, or
// inside quotes. A file that writes some numbers with commas and others with points
// is not guessed at.
#pragma once

#include "solver/files/csv/csv_rows.h"

#include <string>
#include <vector>

namespace keyblock {

/// The numbers of one file; what is wrong with them is reported in `problems`, which outlives this.
class CsvNumbers {
public:
    explicit CsvNumbers(std::vector<Problem>& problems) : problems_(problems) {}

    void separatedBy(char separator) { separator_ = separator; }

    /// Reads a cell. \return false for what is not a number, which is reported with `place`, the column's words.
    bool read(const CsvCell& cell, const std::string& place, double& value);

private:
    bool decimalAgrees(char decimal, int line, const std::string& place);
    void error(int line, std::string message, std::string remedy);

    std::vector<Problem>& problems_;
    char separator_ = ',';
    char decimal_ = '\0';
    int decimalLine_ = 0;
};

/// `column 3 ('load_kN')`; `index` counts from 0.
std::string csvColumnText(std::size_t index, const std::string& title);

/// That a row has more or fewer cells than the header; with nothing wrong, no message.
Problem csvRowProblem(const CsvRow& row, std::size_t columns, char separator);

}  // namespace keyblock
