// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wrapper that hides the buffer of std::to_chars.
#include "solver/scene/number_text.h"

#include "solver/scene/units.h"

#include <array>
#include <charconv>
#include <cmath>

namespace keyblock {

std::string rounded(double number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4);
    return {text.data(), end.ptr};
}

std::string lengthText(double metres) {
    if (std::abs(metres) < 1e-9) return "less than 1 nm";
    if (std::abs(metres) < 1e-4) return rounded(1e6 * metres) + " µm";
    if (std::abs(metres) < 0.1) return rounded(1e3 * metres) + " mm";
    return rounded(metres) + " m";
}

std::string areaText(double squareMetres) {
    if (std::abs(squareMetres) < 1e-4) return rounded(1e6 * squareMetres) + " mm²";
    if (std::abs(squareMetres) < 1e-2) return rounded(1e4 * squareMetres) + " cm²";
    return rounded(squareMetres) + " m²";
}

std::string pressureText(double pascals) {
    for (const char* symbol : {"GPa", "MPa", "kPa"})
        if (const Unit& unit = findUnit(symbol)->unit; std::abs(pascals) >= unit.up)
            return rounded(fromSi(pascals, unit)) + " " + symbol;
    return rounded(pascals) + " Pa";
}

std::string coordinateText(double metres) {
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), metres, std::chars_format::fixed, 3).ptr;
    std::string plain(text.data(), end);
    if (plain.find('.') == std::string::npos) return plain;  // not finite
    plain.erase(plain.find_last_not_of('0') + 1);
    if (plain.ends_with('.')) plain.pop_back();
    return plain == "-0" ? "0" : plain;
}

std::string shortest(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

}  // namespace keyblock
