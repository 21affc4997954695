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
        if (mayBeThousands(cell) && decimal_ != '.') ambiguous_.push_back({cell.line, place, cell.text});
        else if (!decimalAgrees(',', cell.line, place)) return false;
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

/// True for one to three digits that do not begin with 0, a comma and three digits, where cells are separated by commas.
bool CsvNumbers::mayBeThousands(const CsvCell& cell) const {
    std::string_view digits = cell.text;
    if (!digits.empty() && (digits.front() == '-' || digits.front() == '+')) digits.remove_prefix(1);
    const std::size_t comma = digits.find(',');
    const auto isDigit = [](char c) { return c == ',' || (c >= '0' && c <= '9'); };
    return separator_ == ',' && comma >= 1 && comma <= 3 && digits.size() == comma + 4 && digits.front() != '0' &&
           std::all_of(digits.begin(), digits.end(), isDigit);
}

void CsvNumbers::finish() {
    if (decimal_ == ',') return;  // the other numbers show that these are decimal commas
    for (const Ambiguous& number : ambiguous_)
        error(number.line,
              number.place + " holds " + inQuotes(number.text) +
                  ": its comma could be a decimal comma or separate thousands",
              "Write decimal points and no separators of thousands, or separate the cells by semicolons if it is a "
              "decimal comma");
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
