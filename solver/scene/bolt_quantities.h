// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only table of bolt quantities: monitors, scene quantities, the history, charts,
// legends, probes and table columns take their names, units and sign conventions from
// it. Values are read elsewhere: from the state of the engine in
// solver/run/bolt_readings, from the nodes of a stored frame in
// solver/results/frame_quantities.
#pragma once

#include "solver/scene/units.h"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace keyblock {

enum class BoltQuantity {
    AxialForce, ShearForce, Moment, AnchorForce, Slip, PlateForce, DebondedLength, Strain,
    Utilisation,  // (N/N_p)² + (Q/Q_p)²
    UtilisationWithMoment  // (N/N_p)² + (Q/Q_p)² + |M|/M_p
};

/// Part of a bolt to which a value belongs.
enum class BoltPart { Element, Node, Anchor, Bolt };

struct BoltQuantityRow {
    BoltQuantity quantity;
    std::string_view key;  // in scenes and JSON output
    std::string_view column;  // column name in tables: the key and the SI unit
    std::string_view title;  // as shown to the user, ending with the symbol if there is one
    std::string_view brief;  // symbol, or a short title for narrow columns
    std::string_view unit;  // as shown; empty: none
    double factor;  // displayed value = factor · SI value
    std::string_view convention;  // meaning of a positive value; empty: none needed
    bool isSigned;  // true if both signs occur
    BoltPart part;
};

/// All quantities, in the order of `BoltQuantity`.
inline constexpr std::array boltQuantityRows{
    BoltQuantityRow{BoltQuantity::AxialForce, "axial_force", "axial_force_N", "Axial force N", "N", "kN",
                    perSi(namedUnit("kN")), "tension +", true, BoltPart::Element},
    BoltQuantityRow{BoltQuantity::ShearForce, "shear_force", "shear_force_N", "Shear force Q", "Q", "kN",
                    perSi(namedUnit("kN")), "", true, BoltPart::Element},
    BoltQuantityRow{BoltQuantity::Moment, "moment", "moment_Nm", "Moment M", "M", "kN m", perSi(namedUnit("kN m")),
                    "", true, BoltPart::Node},
    BoltQuantityRow{BoltQuantity::AnchorForce, "anchor_force", "anchor_force_N", "Bond force", "Bond", "kN",
                    perSi(namedUnit("kN")), "rock drags the bolt towards the head +", true, BoltPart::Anchor},
    BoltQuantityRow{BoltQuantity::Slip, "slip", "slip_m", "Slip", "Slip", "mm", perSi(namedUnit("mm")),
                    "rock towards the head +", true, BoltPart::Anchor},
    BoltQuantityRow{BoltQuantity::PlateForce, "plate_force", "plate_force_N", "Plate force", "Plate", "kN",
                    perSi(namedUnit("kN")), "", true, BoltPart::Bolt},
    BoltQuantityRow{BoltQuantity::DebondedLength, "debonded_length", "debonded_length_m", "Debonded length",
                    "Debonded", "m", 1.0, "", false, BoltPart::Bolt},
    BoltQuantityRow{BoltQuantity::Strain, "strain", "strain", "Axial strain", "Strain", "mm/m", 1e3, "tension +",
                    true, BoltPart::Element},
    BoltQuantityRow{BoltQuantity::Utilisation, "utilisation", "utilisation", "Utilisation", "Use", "", 1.0, "",
                    false, BoltPart::Element},
    BoltQuantityRow{BoltQuantity::UtilisationWithMoment, "utilisation_with_moment", "utilisation_with_moment",
                    "Utilisation with moment", "Use with M", "", 1.0, "", false, BoltPart::Element}};

/// The row of a quantity. Throws if the quantity has no row, i.e. if the table is incomplete.
constexpr const BoltQuantityRow& rowOf(BoltQuantity quantity) {
    return boltQuantityRows.at(static_cast<std::size_t>(quantity));
}

/// The keys, in the order of `BoltQuantity`.
inline constexpr auto boltQuantityWords = [] {
    std::array<std::string_view, boltQuantityRows.size()> keys;
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = boltQuantityRows[i].key;
    return keys;
}();

/// Title without its symbol, e.g. "Axial force".
constexpr std::string_view plainTitle(const BoltQuantityRow& row) {
    const std::size_t symbol = row.brief.size() + 1;
    const bool has = row.title.size() > symbol && row.title.ends_with(row.brief) &&
                     row.title[row.title.size() - symbol] == ' ';
    return has ? row.title.substr(0, row.title.size() - symbol) : row.title;
}

/// Title with the displayed unit, e.g. "Axial force (kN)".
inline std::string titleWithUnit(const BoltQuantityRow& row) {
    return std::string(plainTitle(row)) + (row.unit.empty() ? "" : " (" + std::string(row.unit) + ")");
}

}  // namespace keyblock
