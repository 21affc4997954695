// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comma-separated values as RFC 4180 has them, with `.` decimals and 17
// significant digits in every locale, so that a table read back gives
// the same doubles.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace keyblock {

/// `value` with 17 significant digits, which read back as the same double; `nan`, `inf`, `-inf`.
std::string exactText(double value);

/// Writes a table cell by cell; rows end with a line feed.
class CsvWriter {
public:
    explicit CsvWriter(std::ostream& out) : out_(out) {}

    /// A text, quoted when it holds a comma, a quote or a line break.
    CsvWriter& text(std::string_view value);
    CsvWriter& number(double value);
    CsvWriter& integer(long value);
    /// An index that −1 marks as not applying: then an empty cell.
    CsvWriter& index(int value);
    void endRow();

private:
    void cell(std::string_view value);

    std::ostream& out_;
    bool rowBegun_ = false;
};

}  // namespace keyblock
