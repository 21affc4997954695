// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/drawing/drawing.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array<LengthUnit, 11> units{{{"m", 1.0, 1.0},
                                            {"mm", 1.0, 1000.0},
                                            {"cm", 1.0, 100.0},
                                            {"dm", 1.0, 10.0},
                                            {"km", 1000.0, 1.0},
                                            {"um", 1.0, 1e6},
                                            {"in", 254.0, 10000.0},
                                            {"ft", 3048.0, 10000.0},
                                            {"yd", 9144.0, 10000.0},
                                            {"mi", 1609344.0, 1000.0},
                                            {"us-ft", 1200.0, 3937.0}}};

}  // namespace

const LengthUnit* lengthUnitOf(std::string_view word) {
    const auto found = std::find_if(units.begin(), units.end(), [&](const LengthUnit& u) { return u.word == word; });
    return found == units.end() ? nullptr : &*found;
}

std::string lengthUnitWords() {
    std::string words;
    for (const LengthUnit& unit : units) words += (words.empty() ? "" : ", ") + std::string(unit.word);
    return words;
}

double inMetres(double number, const LengthUnit& unit) { return number * unit.factor / unit.divisor; }

}  // namespace keyblock
