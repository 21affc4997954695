// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Comma-separated values according to RFC 4180, with a decimal point and 17
// significant digits in every locale, so that reading a table back gives
// the same doubles. Names that a spreadsheet would take for a formula are marked as
// text, because a scene may come from others.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

namespace keyblock {

/// `value` with 17 significant digits, so that reading it back gives the same double; `nan`, `inf` or `-inf` if it is
/// not finite.
std::string exactText(double value);

/// Writes a table cell by cell; rows end with a line feed.
class CsvWriter {
public:
    explicit CsvWriter(std::ostream& out) : out_(out) {}

    /// Writes a string, marked by `withoutFormula` (solver/scene/formula_text.h), in quotes if it contains a comma, a
    /// quote or a line break.
    CsvWriter& text(std::string_view value);
    CsvWriter& number(double value);
    CsvWriter& integer(long value);
    /// Writes an index, or an empty cell for −1 (does not apply).
    CsvWriter& index(int value);
    void endRow();

private:
    void cell(std::string_view value);

    std::ostream& out_;
    bool rowBegun_ = false;
};

}  // namespace keyblock
