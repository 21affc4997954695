// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables for people: columns as wide as their widest cell, numbers to the right.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace keyblock::cli {

/// `value` with six significant digits, `.` decimals in every locale.
std::string shown(double value);

/// `share` as a percentage with two decimals and its sign, as in `+0.12 %`.
std::string shownPercent(double share);

/// Seconds with three decimals.
std::string shownSeconds(double seconds);

/// Number of characters that a UTF-8 text shows.
std::size_t shownWidth(std::string_view text);

enum class Align { Left, Right };

struct TextColumn {
    std::string title;
    Align align = Align::Left;
    std::size_t width = 0;  // at least
};

using TextRow = std::vector<std::string>;

/// Title line and rows, each line ending with a line feed.
/// \pre every row has a cell for every column.
std::string textTable(std::vector<TextColumn> columns, const std::vector<TextRow>& rows);

/// One line of such a table with the present widths of the columns.
std::string textLine(const std::vector<TextColumn>& columns, const TextRow& cells);

}  // namespace keyblock::cli
