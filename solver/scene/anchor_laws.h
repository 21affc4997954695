// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only table of anchor laws: the values that a scene gives for each law, and the
// strength that remains after failure. The field table, the checks, the engine and the
// bolt library panel use it. A new law that is a force–slip curve with elastic unloading
// needs an enumerator and a row here, and its curve in anchor_curve.cpp; the engine does
// not change.
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
    std::string_view title;  // as shown to the user
    bool hasPoints;  // given by `points` and `after`; otherwise by `stiffness`
    bool hasStrength;  // requires `strength`; `friction_angle` and `restick` are optional
    bool hasResidual;  // `residual` and `softening_slip` are optional
    bool keepsStrength;  // after failure it slides at its full strength
};

/// All laws, in the order of `AnchorLaw`.
inline constexpr std::array anchorLaws{
    AnchorLawRow{AnchorLaw::Elastic, "elastic", translatable("Fields", "elastic"), false, false, false, false},
    AnchorLawRow{AnchorLaw::PeakResidual, "peak-residual", translatable("Fields", "peak and residual"), false, true, true,
                 false},
    AnchorLawRow{AnchorLaw::Frictional, "frictional", translatable("Fields", "frictional"), false, true, false, true},
    AnchorLawRow{AnchorLaw::Curve, "curve", translatable("Fields", "force–slip curve"), true, false, false, false}};

/// The row of a law. Throws if the law has no row, i.e. if the table is incomplete.
constexpr const AnchorLawRow& rowOf(AnchorLaw law) { return anchorLaws.at(static_cast<std::size_t>(law)); }

constexpr bool canFail(const AnchorLawRow& row) { return row.hasStrength || row.hasPoints; }

/// The keys, in the order of `AnchorLaw`.
inline constexpr auto anchorLawWords = [] {
    std::array<std::string_view, anchorLaws.size()> keys;
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = anchorLaws[i].key;
    return keys;
}();

/// The titles, in the order of `AnchorLaw`.
inline constexpr auto anchorLawTitles = [] {
    std::array<std::string_view, anchorLaws.size()> titles;
    for (std::size_t i = 0; i < titles.size(); ++i) titles[i] = anchorLaws[i].title;
    return titles;
}();

}  // namespace keyblock
