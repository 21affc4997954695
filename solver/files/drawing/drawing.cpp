// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/drawing.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 11> words{"m", "mm", "cm", "dm", "km", "um", "in", "ft", "yd", "mi", "us-ft"};

}  // namespace

std::span<const std::string_view> lengthUnits() { return words; }

const UnitSymbol* lengthUnitOf(std::string_view word) {
    return std::find(words.begin(), words.end(), word) == words.end() ? nullptr : findUnit(word);
}

std::string lengthUnitWords() {
    std::string text;
    for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

}  // namespace keyblock
