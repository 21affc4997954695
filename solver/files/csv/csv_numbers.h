// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads numbers from CSV cells. A comma between digits is a decimal comma if cells are
// not separated by commas, or within quotes. A file in which some numbers have decimal
// commas and others decimal points is an error. A comma before exactly three digits,
// in quotes in a file whose cells are separated by commas, could also separate
// thousands; it is a decimal comma only if another number of the file shows this.
#pragma once

#include "solver/files/csv/csv_rows.h"

#include <string>
#include <vector>

namespace keyblock {

/// Reads the numbers of one file and reports errors in `problems`. \pre `problems` outlives this object.
class CsvNumbers {
public:
    explicit CsvNumbers(std::vector<Problem>& problems) : problems_(problems) {}

    void separatedBy(char separator) { separator_ = separator; }

    /// Reads the number in a cell into `value`.
    /// \param place the description of the column for messages.
    /// \return false if the cell is not a number; this is reported as an error.
    bool read(const CsvCell& cell, const std::string& place, double& value);

    /// To be called after the last number: reports all numbers whose comma could be either.
    void finish();

private:
    /// A number whose comma could separate thousands.
    struct Ambiguous {
        int line = 0;
        std::string place, text;
    };

    bool mayBeThousands(const CsvCell& cell) const;
    bool decimalAgrees(char decimal, int line, const std::string& place);
    void error(int line, std::string message, std::string remedy);

    std::vector<Problem>& problems_;
    char separator_ = ',';
    char decimal_ = '\0';
    int decimalLine_ = 0;
    std::vector<Ambiguous> ambiguous_;
};

/// Description of a column for messages, as in `column 3 ('load_kN')`.
/// \param index the index of the column, counted from 0.
std::string csvColumnText(std::size_t index, const std::string& title);

/// Error for a row that has more or fewer cells than the header. Its message is empty if the numbers are equal.
/// \param columns the number of cells of the header.
Problem csvRowProblem(const CsvRow& row, std::size_t columns, char separator);

}  // namespace keyblock
