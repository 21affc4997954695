// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Units as written after a number: `mm`, `kN/m`, `kg/m³`, `m/s^2`. A unit is a
// factor and its dimensions, so that units of one kind can be converted and a force
// typed for a length is detected.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// A unit: 1 of it is `up`/`down` in metre, kilogram, second and radian. A fraction, so that 25 mm is exactly 0.025 m.
struct Unit {
    double up = 1.0, down = 1.0;
    std::array<int, 4> powers{};  // of metre, kilogram, second, radian

    bool operator==(const Unit&) const = default;
};

/// Reads products and quotients of known symbols (`N/m per m`, `m⁴`, `1/s`); an empty text is a pure number. None
/// if a symbol is unknown. Text after a comma is a remark of the field table and is ignored.
std::optional<Unit> readUnit(std::string_view text);

/// True if both have the same dimensions and can be converted.
bool sameKind(const Unit& a, const Unit& b);

/// Converts `number` from `from` to `to`. \pre sameKind(from, to).
double converted(double number, const Unit& from, const Unit& to);

/// The quantity of the unit and how it is typed, for messages: `a length (m, mm, cm, km, ft, in)`; empty for kinds
/// without a name.
std::string kindText(const Unit& unit);

}  // namespace keyblock
