// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Parses products of units.
#include "solver/scene/units.h"

#include <cassert>
#include <cctype>
#include <cmath>
#include <cstdlib>

namespace keyblock {
namespace {

using namespace unit_table;

struct Kind {
    std::array<int, 4> powers;
    std::string_view text;
};

constexpr Kind kinds[] = {
    {length, "a length (m, mm, cm, km, ft, in)"},
    {time, "a time (s, ms, min, h)"},
    {angle, "an angle (°, rad)"},
    {force, "a force (N, kN, MN, lbf, kip)"},
    {pressure, "a stress (Pa, kPa, MPa, GPa, bar, psi, ksi)"},
    {moment, "a moment (Nm, kNm, MNm)"},
    {rate, "a rate (1/s, Hz)"},
    {{}, "a pure number (%)"},
    {{2, 0, 0, 0}, "an area (m², cm², mm²)"},
    {{4, 0, 0, 0}, "a second moment of area (m⁴, cm⁴, mm⁴)"},
    {{3, 0, 0, 0}, "a volume (m³, cm³, mm³)"},
    {{-3, 1, 0, 0}, "a density (kg/m³, t/m³)"},
    {{1, 0, -1, 0}, "a velocity (m/s, mm/s)"},
    {{1, 0, -2, 0}, "an acceleration (m/s²)"},
    {{0, 1, -2, 0}, "a stiffness (N/m, kN/m, MN/m)"},
    {{-2, 1, -2, 0}, "a stiffness per area (Pa/m, MPa/m, GPa/m)"},
};

struct Exponent {
    std::string_view text;
    int value;
};
constexpr Exponent exponents[] = {{"²", 2}, {"³", 3}, {"⁴", 4}, {"^2", 2}, {"^3", 3}, {"^4", 4},
                                  {"2", 2}, {"3", 3},  {"4", 4}, {"⁻¹", -1}, {"^-1", -1}, {"⁻²", -2}, {"^-2", -2}};

/// Removes the exponent at the end of a factor and returns it; 1 if there is none.
int takeExponent(std::string_view& factor) {
    for (const Exponent& exponent : exponents)
        if (factor.size() > exponent.text.size() && factor.ends_with(exponent.text)) {
            factor.remove_suffix(exponent.text.size());
            return exponent.value;
        }
    return 1;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
    return text;
}

/// Multiplies or divides the unit by a factor such as `mm²`.
bool apply(std::string_view factor, bool divide, Unit& unit) {
    factor = trimmed(factor);
    int exponent = takeExponent(factor);
    const UnitSymbol* symbol = findUnit(factor);
    if (!symbol) return false;
    const Unit& base = symbol->unit;
    if (divide) exponent = -exponent;
    for (std::size_t i = 0; i < unit.powers.size(); ++i) unit.powers[i] += exponent * base.powers[i];
    for (int n = 0; n < std::abs(exponent); ++n) {
        unit.up *= exponent > 0 ? base.up : base.down;
        unit.down *= exponent > 0 ? base.down : base.up;
    }
    return true;
}

constexpr PracticalUnit practical[] = {
    {"Pa", "MPa"},
    {"N", "kN"},
    {"N m", "kN m"},
    {"J", "kJ"},
    {"m", "mm", UnitUse::Pictures},
    {"rad", "mrad", UnitUse::Pictures},
    {"N·m", "kN m", UnitUse::Forms},
    {"Pa/m", "MPa/m", UnitUse::Forms},
    {"N/m", "kN/m", UnitUse::Forms},
    {"N/m per m", "MN/m²", UnitUse::Forms},
    {"N/m³", "kN/m³", UnitUse::Forms},
};

/// Position and length of the next multiplication or division sign after `from`.
struct Sign {
    std::size_t at, length;
    bool divides;
};
Sign nextSign(std::string_view text, std::size_t from) {
    Sign nearest{text.size(), 0, false};
    const auto look = [&](std::string_view sign, bool divides) {
        const std::size_t at = text.find(sign, from);
        if (at < nearest.at) nearest = {at, sign.size(), divides};
    };
    look("/", true);
    look(" per ", true);
    look("·", false);
    look("*", false);
    return nearest;
}

}  // namespace

std::optional<Unit> readUnit(std::string_view text) {
    text = trimmed(text.substr(0, text.find(',')));
    Unit unit;
    if (text.empty()) return unit;
    bool divide = false;
    for (std::size_t from = 0;;) {
        const Sign sign = nextSign(text, from);
        if (!apply(text.substr(from, sign.at - from), divide, unit)) return std::nullopt;
        if (sign.length == 0) return unit;
        divide = sign.divides;
        from = sign.at + sign.length;
    }
}

std::span<const PracticalUnit> practicalUnits() { return practical; }

bool sameKind(const Unit& a, const Unit& b) { return a.powers == b.powers; }

double converted(double number, const Unit& from, const Unit& to) {
    assert(sameKind(from, to));
    const double up = from.up * to.down, down = from.down * to.up;
    if (up == down) return number;
    // Multiplies or divides once by a whole number, so that no digits are lost.
    if (up > down && std::floor(up / down) == up / down) return number * (up / down);
    if (down > up && std::floor(down / up) == down / up) return number / (down / up);
    return number * up / down;
}

std::string kindText(const Unit& unit) {
    for (const Kind& kind : kinds)
        if (kind.powers == unit.powers) return std::string(kind.text);
    return {};
}

}  // namespace keyblock
