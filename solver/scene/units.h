// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only table of units: file readers, number input, forms and pictures take all unit
// symbols and factors from it. A unit is a factor with its dimensions, so that units of
// the same dimensions can be converted, and a force entered as a length is detected. Each
// reader has its own list of accepted symbols, because `in` (inch) can also be a word.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace keyblock {

/// A unit, equal to `up`/`down` times the SI unit of the same dimensions (composed of m, kg, s and rad). The factor is
/// stored as a fraction, so that 25 mm is exactly 0.025 m.
struct Unit {
    double up = 1.0, down = 1.0;
    std::array<int, 4> powers{};  // exponents of metre, kilogram, second and radian

    bool operator==(const Unit&) const = default;
};

struct UnitSymbol {
    std::string_view text;
    Unit unit;
};

namespace unit_table {
inline constexpr std::array<int, 4> length{1, 0, 0, 0}, mass{0, 1, 0, 0}, time{0, 0, 1, 0}, angle{0, 0, 0, 1};
inline constexpr std::array<int, 4> force{1, 1, -2, 0}, pressure{-1, 1, -2, 0}, moment{2, 1, -2, 0}, rate{0, 0, -1, 0};
inline constexpr double poundForce = 4.4482216152605, squareInch = 0.00064516;  // [N], [m²]

inline constexpr UnitSymbol symbols[] = {
    {"m", {1, 1, length}}, {"mm", {1, 1000, length}}, {"cm", {1, 100, length}}, {"dm", {1, 10, length}},
    {"km", {1000, 1, length}}, {"µm", {1, 1e6, length}}, {"μm", {1, 1e6, length}}, {"um", {1, 1e6, length}},
    {"in", {254, 10000, length}}, {"inch", {254, 10000, length}}, {"ft", {3048, 10000, length}},
    {"yd", {9144, 10000, length}}, {"mi", {1609344, 1000, length}}, {"us-ft", {1200, 3937, length}},
    {"kg", {1, 1, mass}}, {"g", {1, 1000, mass}}, {"t", {1000, 1, mass}}, {"Mg", {1000, 1, mass}},
    {"s", {1, 1, time}}, {"ms", {1, 1000, time}}, {"µs", {1, 1e6, time}}, {"μs", {1, 1e6, time}},
    {"min", {60, 1, time}}, {"h", {3600, 1, time}},
    {"rad", {1, 1, angle}}, {"mrad", {1, 1000, angle}}, {"°", {std::numbers::pi, 180, angle}},
    {"deg", {std::numbers::pi, 180, angle}},
    {"N", {1, 1, force}}, {"kN", {1000, 1, force}}, {"MN", {1e6, 1, force}}, {"lbf", {poundForce, 1, force}},
    {"kip", {1000 * poundForce, 1, force}},
    {"Pa", {1, 1, pressure}}, {"kPa", {1000, 1, pressure}}, {"MPa", {1e6, 1, pressure}}, {"GPa", {1e9, 1, pressure}},
    {"bar", {1e5, 1, pressure}}, {"psi", {poundForce, squareInch, pressure}},
    {"ksi", {1000 * poundForce, squareInch, pressure}},
    {"Nm", {1, 1, moment}}, {"kNm", {1000, 1, moment}}, {"MNm", {1e6, 1, moment}},
    {"N m", {1, 1, moment}}, {"kN m", {1000, 1, moment}}, {"MN m", {1e6, 1, moment}},
    {"J", {1, 1, moment}}, {"kJ", {1000, 1, moment}}, {"MJ", {1e6, 1, moment}},
    {"Hz", {1, 1, rate}},
    {"%", {1, 100, {}}}, {"‰", {1, 1000, {}}}, {"–", {1, 1, {}}}, {"1", {1, 1, {}}},
};
}  // namespace unit_table

/// The table entry for a symbol; null if there is none. For products of symbols, use `readUnit`.
constexpr const UnitSymbol* findUnit(std::string_view symbol) {
    for (const UnitSymbol& known : unit_table::symbols)
        if (known.text == symbol) return &known;
    return nullptr;
}

/// Unit of a symbol that is written in the code; an unknown symbol is a compile-time error.
consteval Unit namedUnit(std::string_view symbol) { return findUnit(symbol)->unit; }

/// Parses products and quotients of known symbols, e.g. `N/m per m`, `m⁴` or `1/s`. An empty string gives a
/// dimensionless unit. Text after a comma is ignored, because it is a remark in the field table.
/// \return the unit; null if a symbol is unknown.
std::optional<Unit> readUnit(std::string_view text);

/// True if both units have the same dimensions, so that one can be converted into the other.
bool sameKind(const Unit& a, const Unit& b);

/// Converts a number from unit `from` to unit `to`. \pre sameKind(from, to).
double converted(double number, const Unit& from, const Unit& to);

constexpr double toSi(double number, const Unit& unit) { return number * unit.up / unit.down; }
constexpr double fromSi(double value, const Unit& unit) { return value * unit.down / unit.up; }

/// Factor that converts an SI value to this unit, e.g. 0.001 for kN.
constexpr double perSi(const Unit& unit) { return unit.down / unit.up; }

/// Quantity that the unit measures, with examples of its units, for messages, e.g. `a length (m, mm, cm, km, ft, in)`.
/// Empty if there is no name for this quantity.
std::string kindText(const Unit& unit);

/// Where a practical unit is displayed instead of the SI unit. Forms show lengths in metres, since sections are entered
/// in metres.
enum class UnitUse { Everywhere, Forms, Pictures };

struct PracticalUnit {
    std::string_view si, practical;  // in the notation of `readUnit`
    UnitUse use = UnitUse::Everywhere;
};

/// Units in which numbers are shown unless the user chooses SI, e.g. MPa for Pa and kN for N.
std::span<const PracticalUnit> practicalUnits();

}  // namespace keyblock
