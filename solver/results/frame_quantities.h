// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of what can be read off a frame: a row gives a number of a block,
// a contact or a node of a bolt its name, its column in the tables and the way
// figures show it. A new quantity is one row, and tables and figures have it. Rows of
// bolts take all but the reading from solver/scene/bolt_quantities.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/bolt_quantities.h"

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace keyblock {

/// How people are shown a number: title, unit, and what a positive one means.
struct QuantityDisplay {
    std::string_view title;  // Block stress σ₁
    std::string_view unit;  // MPa
    double factor = 1.0;  // shown = factor · SI; negative where the shown sign is the other one
    std::string_view convention;  // of what is shown: compression +
    bool isSigned = false;  // both signs are alike, and 0 is the middle of the colours
};

/// A number of a row of a frame.
template <typename Row>
struct FrameQuantity {
    std::string_view name;  // as the user requests it: sigma1
    std::string_view column;  // in tables, with its SI unit: sigma1_compressive_Pa
    double (*value)(const Row&);  // SI
    QuantityDisplay display;
};

// Each list in the order of the table's columns.
std::span<const FrameQuantity<BlockState>> blockQuantities();
std::span<const FrameQuantity<ContactFrame>> contactQuantities();
std::span<const FrameQuantity<BoltNodeFrame>> boltQuantities();
std::span<const FrameQuantity<Energy>> energyQuantities();

/// The row of that name; null when there is none.
template <typename Row>
const FrameQuantity<Row>* findQuantity(std::span<const FrameQuantity<Row>> rows, std::string_view name) {
    for (const FrameQuantity<Row>& row : rows)
        if (row.name == name) return &row;
    return nullptr;
}

/// The row of a bolt quantity; null of one that frames do not keep along the bolt.
const FrameQuantity<BoltNodeFrame>* findQuantity(BoltQuantity quantity);

/// What the quantity is. \pre one of `boltQuantities()`.
const BoltQuantityRow& rowOf(const FrameQuantity<BoltNodeFrame>& quantity);

/// The names in the list, with commas between.
template <typename Row>
std::string namesOf(std::span<const FrameQuantity<Row>> rows) {
    std::string names;
    for (const FrameQuantity<Row>& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

/// A quantity of bolts whose largest value over the run is kept.
struct BoltPeakRow {
    BoltQuantity quantity;
    BoltPeak BoltExtremes::*peak;
};

inline constexpr std::array boltPeakRows{BoltPeakRow{BoltQuantity::AxialForce, &BoltExtremes::axialForce},
                                         BoltPeakRow{BoltQuantity::ShearForce, &BoltExtremes::shearForce},
                                         BoltPeakRow{BoltQuantity::Moment, &BoltExtremes::moment}};

/// The largest value of a quantity of bolts over the run until a frame; null where none is kept.
const BoltPeak* peakOf(const BoltExtremes& extremes, std::string_view quantity);

/// The extreme of a quantity of blocks over the run until a frame; null where none is kept.
const BlockPeak* peakOf(const BlockExtremes& extremes, std::string_view quantity);

/// Force with which block b pushes block a [N]; −1 times that is the force on b.
Point forceOnA(const ContactFrame& contact);

/// Principal stresses in the plane, compression positive.
struct PrincipalStress {
    double major = 0.0, minor = 0.0;  // σ₁ ≥ σ₃ [Pa]
    Point direction{1.0, 0.0};  // of σ₁, a unit vector; along x where both are equal
};

/// σ₁ and σ₃ of sxx, syy, sxy [Pa], which are positive in tension; σ₁ and σ₃ are positive in compression.
std::pair<double, double> principalValues(const std::array<double, 3>& stress);

/// The same with the direction of σ₁.
PrincipalStress principalStress(const std::array<double, 3>& stress);

}  // namespace keyblock
