// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/drawing.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<std::string_view, 11> unitWords{"m", "mm", "cm", "dm", "km", "um", "in", "ft", "yd", "mi", "us-ft"};

}  // namespace

std::span<const std::string_view> lengthUnits() { return unitWords; }

const UnitSymbol* lengthUnitOf(std::string_view word) {
    return std::find(unitWords.begin(), unitWords.end(), word) == unitWords.end() ? nullptr : findUnit(word);
}

std::string lengthUnitWords() {
    std::string text;
    for (const std::string_view word : unitWords) text += (text.empty() ? "" : ", ") + std::string(word);
    return text;
}

}  // namespace keyblock
