// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text tables for display: columns as wide as their widest cell, numbers aligned to
// the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock::cli {

/// `value` with six significant digits; the decimal separator is a point in every locale.
std::string shown(double value);

/// The fraction `share` as a percentage with two decimals and a sign, as in `+0.12 %`; zero has no sign.
std::string shownPercent(double share);

/// `seconds` with three decimals, without the unit.
std::string shownSeconds(double seconds);

/// Number of characters in a UTF-8 string.
std::size_t shownWidth(std::string_view text);

enum class Align { Left, Right };

struct TextColumn {
    std::string title;
    Align align = Align::Left;
    std::size_t width = 0;  // minimum width in characters
};

using TextRow = std::vector<std::string>;

/// A table with a title line and one line per row; every line ends with a line feed.
/// \pre every row has a cell for every column.
std::string textTable(std::vector<TextColumn> columns, const std::vector<TextRow>& rows);

/// One line of a table, ending with a line feed. A cell longer than its column is written in full and shifts the cells
/// after it.
/// \pre there is a cell for every column.
std::string textLine(const std::vector<TextColumn>& columns, const TextRow& cells);

}  // namespace keyblock::cli
