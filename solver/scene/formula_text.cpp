// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/formula_text.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace keyblock {

namespace {

bool isNumber(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    return failure == std::errc() && end == text.data() + text.size();
}

/// Whether the text is one that begins a formula, with any number of apostrophes before it.
bool isFormula(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
    return !text.empty() && std::string_view("=+-@\t\r\n").find(text.front()) != std::string_view::npos;
}

}  // namespace

std::string withoutFormula(std::string_view text) {
    return (isFormula(text) && !isNumber(text) ? "'" : "") + std::string(text);
}

std::string_view asBeforeMarking(std::string_view cell) {
    if (cell.starts_with('\'') && isFormula(cell)) cell.remove_prefix(1);
    return cell;
}

}  // namespace keyblock
