// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of the quantities that can be read from a frame. Each row gives a
// quantity of a block, contact or bolt node its name, its column in the tables and
// its display in figures; adding a row adds the quantity to tables and figures. Rows
// for bolts define only how the value is read; solver/scene/bolt_quantities has the rest.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/bolt_quantities.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace keyblock {

/// How a quantity is displayed: title, unit and sign convention.
struct QuantityDisplay {
    std::string_view title;  // Block stress σ₁
    std::string_view unit;  // MPa
    double factor = 1.0;  // displayed value = factor · SI value; negative if the displayed sign is reversed
    std::string_view convention;  // sign convention of the displayed value: compression +
    bool isSigned = false;  // both signs occur, so the colour scale is centred on 0
};

/// A quantity that can be read from a frame. `Row` is the struct from which it is read: a block, a contact, a bolt node
/// or the energy balance.
template <typename Row>
struct FrameQuantity {
    std::string_view name;  // name by which the user requests it: sigma1
    std::string_view column;  // column name in tables, with its SI unit: sigma1_compressive_Pa
    double (*value)(const Row&);  // SI
    QuantityDisplay display;
};

// Each list is in the order of the columns of its table.
std::span<const FrameQuantity<BlockState>> blockQuantities();
std::span<const FrameQuantity<ContactFrame>> contactQuantities();
std::span<const FrameQuantity<BoltNodeFrame>> boltQuantities();
std::span<const FrameQuantity<Energy>> energyQuantities();

/// The quantity with this name; null if there is none.
template <typename Row>
const FrameQuantity<Row>* findQuantity(std::span<const FrameQuantity<Row>> rows, std::string_view name) {
    for (const FrameQuantity<Row>& row : rows)
        if (row.name == name) return &row;
    return nullptr;
}

/// The frame quantity that corresponds to a bolt quantity; null if frames do not store this quantity for each node.
const FrameQuantity<BoltNodeFrame>* findQuantity(BoltQuantity quantity);

/// The row of `boltQuantityRows` that describes a bolt quantity. \pre `quantity` is an element of `boltQuantities()`.
const BoltQuantityRow& rowOf(const FrameQuantity<BoltNodeFrame>& quantity);

/// Comma-separated names of the quantities in the list.
template <typename Row>
std::string namesOf(std::span<const FrameQuantity<Row>> rows) {
    std::string names;
    for (const FrameQuantity<Row>& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

/// A bolt quantity whose largest value over the run is recorded.
struct BoltPeakRow {
    BoltQuantity quantity;
    BoltPeak BoltExtremes::*peak;
};

inline constexpr std::array boltPeakRows{BoltPeakRow{BoltQuantity::AxialForce, &BoltExtremes::axialForce},
                                         BoltPeakRow{BoltQuantity::ShearForce, &BoltExtremes::shearForce},
                                         BoltPeakRow{BoltQuantity::Moment, &BoltExtremes::moment}};

/// The entry of `extremes` for the bolt quantity with this name; null if no extreme of it is recorded.
const BoltPeak* peakOf(const BoltExtremes& extremes, std::string_view quantity);

/// The entry of `extremes` for the block quantity with this name; null if extremes of this quantity are not recorded, or
/// if none has been recorded yet.
const BlockPeak* peakOf(const BlockExtremes& extremes, std::string_view quantity);

/// Contact force on block `contact.blockA` [N]; the force on block `contact.blockB` is equal and opposite.
Point forceOnA(const ContactFrame& contact);

/// In-plane principal stresses, compression positive.
struct PrincipalStress {
    double major = 0.0, minor = 0.0;  // σ₁ ≥ σ₃ [Pa]
    Point direction{1.0, 0.0};  // unit vector in the direction of σ₁; along x if both stresses are equal
};

/// Principal stresses [Pa], compression positive: first σ₁ (the larger), then σ₃.
/// \param stress the components sxx, syy and sxy [Pa], tension positive.
std::pair<double, double> principalValues(const std::array<double, 3>& stress);

/// Principal stresses and the direction of σ₁.
/// \param stress the components sxx, syy and sxy [Pa], tension positive.
PrincipalStress principalStress(const std::array<double, 3>& stress);

}  // namespace keyblock
