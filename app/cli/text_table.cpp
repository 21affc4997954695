// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Widths count characters, not bytes, so that names in any language line up.
#include "app/cli/text_table.h"

#include "solver/scene/visible_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keyblock::cli {

namespace {

std::string formatted(double value, std::chars_format format, int precision) {
    std::array<char, 400> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision);
    return {buffer.data(), end.ptr};
}

TextRow titlesOf(const std::vector<TextColumn>& columns) {
    TextRow titles;
    for (const TextColumn& column : columns)
        titles.push_back(column.title);
    return titles;
}

void widen(std::vector<TextColumn>& columns, const TextRow& cells) {
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i].width = std::max(columns[i].width, shownWidth(visibleText(cells[i])));
}

}  // namespace

std::string shown(double value) { return formatted(value, std::chars_format::general, 6); }

std::string shownPercent(double share) {
    const std::string digits = formatted(std::abs(100.0 * share), std::chars_format::fixed, 2);
    const bool isNothing = digits == "0.00";
    return (isNothing ? "" : share < 0.0 ? "-" : "+") + digits + " %";
}

std::string shownSeconds(double seconds) { return formatted(seconds, std::chars_format::fixed, 3); }

std::size_t shownWidth(std::string_view text) {
    const auto startsCharacter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
    return std::count_if(text.begin(), text.end(), startsCharacter);
}

std::string textLine(const std::vector<TextColumn>& columns, const TextRow& cells) {
    std::string line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const std::string cell = visibleText(cells[i]);
        const std::size_t used = shownWidth(cell);
        const std::string gap(columns[i].width > used ? columns[i].width - used : 0, ' ');
        line += i == 0 ? "" : "  ";
        line += columns[i].align == Align::Right ? gap + cell : cell + gap;
    }
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
}

std::string textTable(std::vector<TextColumn> columns, const std::vector<TextRow>& rows) {
    widen(columns, titlesOf(columns));
    for (const TextRow& row : rows)
        widen(columns, row);
    std::string text = textLine(columns, titlesOf(columns));
    for (const TextRow& row : rows)
        text += textLine(columns, row);
    return text;
}

}  // namespace keyblock::cli
