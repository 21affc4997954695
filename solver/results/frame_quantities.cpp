// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tables keep the signs of the results (tension positive). Figures show rock stress
// with compression positive, as is usual in rock mechanics, and state this.
#include "solver/results/frame_quantities.h"

#include "solver/scene/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

using OfBlock = const BlockState&;
using OfContact = const ContactFrame&;
using OfNode = const BoltNodeFrame&;
using OfEnergy = const Energy&;

constexpr QuantityDisplay millimetres(std::string_view title, std::string_view convention, bool isSigned) {
    return {title, "mm", perSi(namedUnit("mm")), convention, isSigned};
}
constexpr QuantityDisplay stress(std::string_view title, double sign, std::string_view convention, bool isSigned) {
    return {title, "MPa", sign * perSi(namedUnit("MPa")), convention, isSigned};
}
constexpr QuantityDisplay velocity(std::string_view title, std::string_view convention, bool isSigned) {
    return {title, "m/s", 1.0, convention, isSigned};
}
constexpr QuantityDisplay force(std::string_view title, std::string_view convention, bool isSigned) {
    return {title, "kN", perSi(namedUnit("kN")), convention, isSigned};
}
constexpr QuantityDisplay energy(std::string_view title) { return {title, "kJ", perSi(namedUnit("kJ")), "", true}; }

const FrameQuantity<BlockState> ofBlocks[]{
    {"ux", "ux_m", [](OfBlock b) { return b.displacement.x(); }, millimetres("Displacement along x", "to the right +", true)},
    {"uy", "uy_m", [](OfBlock b) { return b.displacement.y(); }, millimetres("Displacement along y", "upwards +", true)},
    {"rotation", "rotation_rad", [](OfBlock b) { return b.rotation; },
     {"Rotation", "mrad", perSi(namedUnit("mrad")), "counter-clockwise +", true}},
    {"sxx", "sxx_Pa", [](OfBlock b) { return b.stress[0]; }, stress("Block stress σxx", -1.0, "compression +", true)},
    {"syy", "syy_Pa", [](OfBlock b) { return b.stress[1]; }, stress("Block stress σyy", -1.0, "compression +", true)},
    {"sxy", "sxy_Pa", [](OfBlock b) { return b.stress[2]; },
     stress("Block stress σxy", 1.0, "on a face to the right, upwards +", true)},
    {"vx", "vx_m_per_s", [](OfBlock b) { return b.velocity.x(); }, velocity("Velocity along x", "to the right +", true)},
    {"vy", "vy_m_per_s", [](OfBlock b) { return b.velocity.y(); }, velocity("Velocity along y", "upwards +", true)},
    {"area", "area_m2", [](OfBlock b) { return b.area; }, {"Area", "m²", 1.0, "", false}},
    {"weight", "weight_N", [](OfBlock b) { return b.weight; }, force("Weight", "", false)},
    {"displacement", "displacement_m", [](OfBlock b) { return b.displacement.norm(); },
     millimetres("Displacement", "length of the vector", false)},
    {"velocity", "speed_m_per_s", [](OfBlock b) { return b.velocity.norm(); },
     velocity("Velocity", "length of the vector", false)},
    {"sigma1", "sigma1_compressive_Pa", [](OfBlock b) { return principalValues(b.stress).first; },
     stress("Block stress σ₁", 1.0, "major principal, compression +", false)},
    {"sigma3", "sigma3_compressive_Pa", [](OfBlock b) { return principalValues(b.stress).second; },
     stress("Block stress σ₃", 1.0, "minor principal, compression +", false)},
};

const FrameQuantity<ContactFrame> ofContacts[]{
    {"normal_force", "normal_force_N", [](OfContact c) { return c.normalForce; },
     force("Contact normal force", "compression +", false)},
    {"contact_shear_force", "shear_force_N", [](OfContact c) { return c.shearForce; },
     force("Contact shear force", "", true)},
    {"penetration", "penetration_m", [](OfContact c) { return c.penetration; },
     millimetres("Penetration", "corner inside +", true)},
    {"contact_slip", "slip_m", [](OfContact c) { return c.slip; }, millimetres("Contact slip", "", true)},
    {"normal_x", "nx", [](OfContact c) { return c.normal.x(); },
     {"Contact normal along x", "", 1.0, "push on block a", true}},
    {"normal_y", "ny", [](OfContact c) { return c.normal.y(); },
     {"Contact normal along y", "", 1.0, "push on block a", true}},
};

/// A bolt quantity that is read from a node of a frame.
constexpr FrameQuantity<BoltNodeFrame> ofNode(BoltQuantity quantity, double (*value)(OfNode)) {
    const BoltQuantityRow& row = rowOf(quantity);
    return {row.key, row.column, value, {row.title, row.unit, row.factor, row.convention, row.isSigned}};
}

constexpr FrameQuantity<BoltNodeFrame> ofNodes[]{
    ofNode(BoltQuantity::AxialForce, [](OfNode n) { return n.axialForce; }),
    ofNode(BoltQuantity::ShearForce, [](OfNode n) { return n.shearForce; }),
    ofNode(BoltQuantity::Moment, [](OfNode n) { return n.moment; }),
    ofNode(BoltQuantity::AnchorForce, [](OfNode n) { return n.anchorForce; }),
    ofNode(BoltQuantity::Slip, [](OfNode n) { return n.slip; }),
};

const FrameQuantity<Energy> ofEnergy[]{
    {"kinetic", "kinetic_J", [](OfEnergy e) { return e.kinetic; }, energy("kinetic")},
    {"strain", "strain_J", [](OfEnergy e) { return e.strain; }, energy("strain of blocks")},
    {"contact", "contact_J", [](OfEnergy e) { return e.contact; }, energy("contacts")},
    {"bolt", "bolt_J", [](OfEnergy e) { return e.bolt; }, energy("bolts, elastic")},
    {"friction", "friction_J", [](OfEnergy e) { return e.friction; }, energy("friction")},
    {"plastic", "plastic_J", [](OfEnergy e) { return e.plastic; }, energy("plastic")},
    {"released", "released_J", [](OfEnergy e) { return e.released; }, energy("released")},
    {"damped", "damped_J", [](OfEnergy e) { return e.damped; }, energy("damped")},
    {"external", "external_J", [](OfEnergy e) { return e.external; }, energy("external")},
    {"balance_error", "balance_error", [](OfEnergy e) { return e.balanceError; },
     {"balance error", "", 1.0, "over the largest term", true}},
};

}  // namespace

std::span<const FrameQuantity<BlockState>> blockQuantities() { return ofBlocks; }
std::span<const FrameQuantity<ContactFrame>> contactQuantities() { return ofContacts; }
std::span<const FrameQuantity<BoltNodeFrame>> boltQuantities() { return ofNodes; }
std::span<const FrameQuantity<Energy>> energyQuantities() { return ofEnergy; }

const FrameQuantity<BoltNodeFrame>* findQuantity(BoltQuantity quantity) {
    return findQuantity(boltQuantities(), rowOf(quantity).key);
}

const BoltQuantityRow& rowOf(const FrameQuantity<BoltNodeFrame>& quantity) {
    const auto row = std::ranges::find(boltQuantityRows, quantity.name, &BoltQuantityRow::key);
    assert(row != boltQuantityRows.end());
    return *row;
}

const BoltPeak* peakOf(const BoltExtremes& extremes, std::string_view quantity) {
    for (const BoltPeakRow& row : boltPeakRows)
        if (rowOf(row.quantity).key == quantity) return &(extremes.*row.peak);
    return nullptr;
}

const BlockPeak* peakOf(const BlockExtremes& extremes, std::string_view quantity) {
    const BlockPeak* peak = quantity == "displacement" ? &extremes.displacement
                            : quantity == "velocity"   ? &extremes.velocity
                            : quantity == "sigma1"     ? &extremes.sigma1
                            : quantity == "sigma3"     ? &extremes.sigma3
                                                       : nullptr;
    return peak && peak->stage >= 0 ? peak : nullptr;
}

Point forceOnA(const ContactFrame& contact) {
    return contact.normalForce * contact.normal - contact.shearForce * turnLeft(contact.normal);
}

std::pair<double, double> principalValues(const std::array<double, 3>& stress) {
    const auto [sxx, syy, sxy] = stress;
    const double mean = 0.5 * (sxx + syy);
    const double radius = std::hypot(0.5 * (sxx - syy), sxy);
    return {radius - mean, -mean - radius};
}

PrincipalStress principalStress(const std::array<double, 3>& stress) {
    const auto [sxx, syy, sxy] = stress;
    const auto [major, minor] = principalValues(stress);
    PrincipalStress principal{major, minor, {1.0, 0.0}};
    if (sxx == syy && sxy == 0.0) return principal;
    // direction of the normal with the largest compression
    const double angle = 0.5 * std::atan2(-2.0 * sxy, syy - sxx);
    principal.direction = Point(std::cos(angle), std::sin(angle));
    return principal;
}

}  // namespace keyblock
