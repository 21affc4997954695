// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of anchor laws: which numbers a scene gives for a law, and what is left
// when it fails. Fields, checks, the engine and the library of the window read it. A law
// that is a curve of force over slip with elastic unloading is an enumerator and a row
// here, and its curve in anchor_curve.cpp; the engine needs nothing else.
#pragma once

#include "solver/scene/translatable.h"

#include <array>
#include <cstddef>
#include <string_view>

namespace keyblock {

enum class AnchorLaw { Elastic, PeakResidual, Frictional, Curve };

struct AnchorLawRow {
    AnchorLaw law;
    std::string_view key;  // in files
    std::string_view title;  // as users read it
    bool hasPoints;  // given by `points` and `after`; otherwise by `stiffness` and the numbers below
    bool hasStrength;  // needs `strength`; may have `friction_angle` and `restick`
    bool hasResidual;  // may have `residual` and `softening_slip`
    bool keepsStrength;  // slides at its strength
};

/// In the order of `AnchorLaw`.
inline constexpr std::array anchorLaws{
    AnchorLawRow{AnchorLaw::Elastic, "elastic", translatable("Fields", "elastic"), false, false, false, false},
    AnchorLawRow{AnchorLaw::PeakResidual, "peak-residual", translatable("Fields", "peak and residual"), false, true, true,
                 false},
    AnchorLawRow{AnchorLaw::Frictional, "frictional", translatable("Fields", "frictional"), false, true, false, true},
    AnchorLawRow{AnchorLaw::Curve, "curve", translatable("Fields", "force–slip curve"), true, false, false, false}};

/// The row of a law. A law without a row ends the program: the table is incomplete.
constexpr const AnchorLawRow& rowOf(AnchorLaw law) { return anchorLaws.at(static_cast<std::size_t>(law)); }

constexpr bool canFail(const AnchorLawRow& row) { return row.hasStrength || row.hasPoints; }

/// The keys, in the order of `AnchorLaw`.
inline constexpr auto anchorLawWords = [] {
    std::array<std::string_view, anchorLaws.size()> keys;
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = anchorLaws[i].key;
    return keys;
}();

/// The titles, in the same order.
inline constexpr auto anchorLawTitles = [] {
    std::array<std::string_view, anchorLaws.size()> titles;
    for (std::size_t i = 0; i < titles.size(); ++i) titles[i] = anchorLaws[i].title;
    return titles;
}();

}  // namespace keyblock
