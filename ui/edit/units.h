// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Units as people write them beside a number: `mm`, `kN/m`, `kg/m³`, `m/s^2`. A
// unit is a factor and its dimensions, so that any two of one kind convert and a
// force typed for a length is told.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace keyblock {

/// A unit: 1 of it is `up`/`down` in metre, kilogram, second and radian. Two numbers, so that 25 mm is 0.025 m exactly.
struct Unit {
    double up = 1.0, down = 1.0;
    std::array<int, 4> powers{};  // of metre, kilogram, second, radian

    bool operator==(const Unit&) const = default;
};

/// Reads products and quotients of known symbols (`N/m per m`, `m⁴`, `1/s`); a text without any is a pure number. None
/// where a symbol is unknown. What follows a comma is a remark of the field's row and is left out.
std::optional<Unit> readUnit(std::string_view text);

/// True when both measure the same, so that one converts into the other.
bool sameKind(const Unit& a, const Unit& b);

/// `number` in `from` told in `to`. \pre sameKind(from, to).
double converted(double number, const Unit& from, const Unit& to);

/// What the unit measures and how it is typed, for people: `a length (m, mm, cm, km, ft, in)`; empty for kinds without
/// a name.
std::string kindText(const Unit& unit);

}  // namespace keyblock
