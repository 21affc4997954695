// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/csv/csv_numbers.h"

#include "solver/files/csv/number_text_reader.h"
#include "solver/scene/suggest.h"

#include <algorithm>

namespace keyblock {

bool CsvNumbers::read(const CsvCell& cell, const std::string& place, double& value) {
    std::string digits = cell.text;
    const auto commas = std::count(digits.begin(), digits.end(), ',');
    const bool point = digits.find('.') != std::string::npos;
    if (commas == 1 && !point && (separator_ != ',' || cell.quoted)) {
        if (!decimalAgrees(',', cell.line, place)) return false;
        std::replace(digits.begin(), digits.end(), ',', '.');
    } else if (point && !decimalAgrees('.', cell.line, place)) {
        return false;
    }
    if (readReal(digits, value)) return true;
    error(cell.line, place + " holds " + inQuotes(cell.text) + ", which is not a number",
          cell.text.empty() ? "Fill in a number" : "Write digits with one decimal point or comma, without spaces or "
                                                   "other separators");
    return false;
}

bool CsvNumbers::decimalAgrees(char decimal, int line, const std::string& place) {
    if (decimal_ == '\0') decimal_ = decimal, decimalLine_ = line;
    if (decimal_ == decimal) return true;
    error(line,
          place + " has a decimal " + (decimal == ',' ? "comma" : "point") + ", and line " +
              std::to_string(decimalLine_) + " has a " + (decimal == ',' ? "point" : "comma"),
          "Use the same decimal separator in the whole file");
    return false;
}

void CsvNumbers::error(int line, std::string message, std::string remedy) {
    addProblem(problems_, {Severity::Error, "", line, "", std::move(message), std::move(remedy)});
}

std::string csvColumnText(std::size_t index, const std::string& title) {
    return "column " + std::to_string(index + 1) + (title.empty() ? "" : " (" + inQuotes(title) + ")");
}

Problem csvRowProblem(const CsvRow& row, std::size_t columns, char separator) {
    if (row.size() == columns) return {};
    return {Severity::Error,
            "",
            row.front().line,
            "",
            "the row has " + std::to_string(row.size()) + " cells, and the header " + std::to_string(columns),
            separator == ',' ? "Use decimal points, or put numbers with decimal commas in quotes" : "Correct the row"};
}

}  // namespace keyblock
