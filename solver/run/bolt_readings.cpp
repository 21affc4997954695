// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/bolt_readings.h"

#include "solver/engine/bolt/anchor.h"
#include "solver/engine/bolt/shank.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {
namespace {

int elementAt(const BoltModel& bolt, double s) {
    const auto after = std::upper_bound(bolt.s.begin(), bolt.s.end(), s * (1.0 + 1e-12));
    const auto element = static_cast<int>(after - bolt.s.begin()) - 1;
    return std::clamp(element, 0, static_cast<int>(bolt.elements.size()) - 1);
}

int nodeAt(const BoltModel& bolt, double s) {
    const int e = elementAt(bolt, s);
    return s - bolt.s[e] <= bolt.s[e + 1] - s ? e : e + 1;
}

double debondedLength(const BoltModel& bolt, const BoltMotion& motion) {
    double length = 0.0;
    for (std::size_t n = 0; n < motion.nodes.size(); ++n) {
        const BoltNode& node = motion.nodes[n];
        if (!bolt.anchors[n].real || node.slot < 0 || node.bond.bonded) continue;
        if (n > 0) length += 0.5 * bolt.elements[n - 1].length;
        if (n < bolt.elements.size()) length += 0.5 * bolt.elements[n].length;
    }
    return length;
}

/// The larger of the two end moments of an element, with its sign.
double largerMoment(const BoltElementState& e) {
    return std::abs(e.moment1) > std::abs(e.moment2) ? -e.moment1 : e.moment2;
}

double momentBetween(const BoltElementState& e, double share) {
    return (1.0 - share) * -e.moment1 + share * e.moment2;
}

using OfBolt = const BoltModel&;
using OfMotion = const BoltMotion&;
using OfState = const BoltElementState&;

/// How a quantity is read: per element, per node or for the whole bolt.
struct Reading {
    BoltQuantity quantity;
    double (*ofElement)(OfBolt, OfMotion, int element) = nullptr;
    double (*ofNode)(const BoltNode&) = nullptr;
    double (*ofBolt)(OfBolt, OfMotion) = nullptr;
    // for elements: value at a fraction of the length; null: constant
    double (*between)(OfState, double share) = nullptr;
};

/// In the order of `BoltQuantity`.
constexpr std::array readings{
    Reading{.quantity = BoltQuantity::AxialForce,
            .ofElement = [](OfBolt, OfMotion motion, int e) { return motion.elements[e].axialForce; }},
    Reading{.quantity = BoltQuantity::ShearForce,
            .ofElement = [](OfBolt, OfMotion motion, int e) { return motion.elements[e].shearForce; }},
    Reading{.quantity = BoltQuantity::Moment,
            .ofElement = [](OfBolt, OfMotion motion, int e) { return largerMoment(motion.elements[e]); },
            .between = momentBetween},
    Reading{.quantity = BoltQuantity::AnchorForce, .ofNode = [](const BoltNode& node) { return node.bond.force; }},
    Reading{.quantity = BoltQuantity::Slip, .ofNode = [](const BoltNode& node) { return node.bond.slip; }},
    Reading{.quantity = BoltQuantity::PlateForce, .ofBolt = [](OfBolt, OfMotion motion) { return motion.plateNormal; }},
    Reading{.quantity = BoltQuantity::DebondedLength, .ofBolt = debondedLength},
    Reading{.quantity = BoltQuantity::Strain,
            .ofElement = [](OfBolt, OfMotion motion, int e) { return motion.elements[e].strain; }},
    Reading{.quantity = BoltQuantity::Utilisation,
            .ofElement = [](OfBolt bolt, OfMotion motion, int e) { return utilisationOf(bolt, motion, e).forces; }},
    Reading{.quantity = BoltQuantity::UtilisationWithMoment,
            .ofElement = [](OfBolt bolt, OfMotion motion, int e) {
                return utilisationOf(bolt, motion, e).withMoment;
            }}};
static_assert(readings.size() == boltQuantityRows.size(), "every bolt quantity has a reading");
static_assert(
    [] {
        for (std::size_t i = 0; i < readings.size(); ++i)
            if (readings[i].quantity != boltQuantityRows[i].quantity) return false;
        return true;
    }(),
    "readings have the order of the bolt quantities");

const Reading& readingOf(BoltQuantity quantity) { return readings[static_cast<std::size_t>(quantity)]; }

NodeState stateOf(const AnchorModel& anchor, const BoltNode& node) {
    if (node.slot < 0) return NodeState::Free;
    if (!anchor.real || node.bond.gone) return NodeState::Gone;
    return node.bond.bonded ? NodeState::Bonded : NodeState::Slipping;
}

/// Adds the strength of a node's bond, at its peak and while it slides.
void addBondLimits(const AnchorModel& anchor, const BoltMotion& motion, const BoltNode& node, BoltNodeFrame& frame) {
    frame.bondStrength = bondStrengthNow(anchor, motion, node);
    if (frame.bondStrength > 0.0 && !anchor.curve)
        frame.bondResidual = slidingLimit(anchor, node, motion.strength.bond) * node.bond.share;
}

}  // namespace

double boltValueAt(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity, double s) {
    const Reading& reading = readingOf(quantity);
    if (reading.ofBolt) return reading.ofBolt(bolt, motion);
    if (reading.ofNode) return reading.ofNode(motion.nodes[nodeAt(bolt, s)]);
    const int e = elementAt(bolt, s);
    if (!reading.between) return reading.ofElement(bolt, motion, e);
    return reading.between(motion.elements[e], (s - bolt.s[e]) / bolt.elements[e].length);
}

double boltExtreme(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity) {
    const Reading& reading = readingOf(quantity);
    if (reading.ofBolt) return reading.ofBolt(bolt, motion);
    double extreme = 0.0;
    const auto take = [&](double value) {
        if (std::abs(value) > std::abs(extreme)) extreme = value;
    };
    if (reading.ofNode)
        for (const BoltNode& node : motion.nodes) take(reading.ofNode(node));
    else
        for (int e = 0; e < static_cast<int>(motion.elements.size()); ++e) take(reading.ofElement(bolt, motion, e));
    return extreme;
}

double bondStrengthNow(const AnchorModel& anchor, const BoltMotion& motion, const BoltNode& node) {
    if (!anchor.real || node.slot < 0 || node.bond.gone) return 0.0;
    if (const Backbone* curve = curveNow(anchor, motion))
        return *std::max_element(curve->force.begin(), curve->force.end()) * node.bond.share;
    return bondStrength(anchor, node, motion.strength.bond).value_or(0.0);
}

BoltFrame boltFrame(const BoltModel& bolt, const BoltMotion& motion, const Point& origin) {
    BoltFrame frame;
    frame.plateHolds = motion.plateHolds;
    frame.lost = motion.lost;
    frame.plasticEnergy = motion.plasticEnergy;
    frame.bondEnergy = motion.bondEnergy;
    if (motion.absent) return frame;
    for (std::size_t n = 0; n < motion.nodes.size(); ++n) {
        const BoltNode& node = motion.nodes[n];
        BoltNodeFrame f;
        f.s = bolt.s[n];
        f.position = node.x + origin;
        f.block = node.slot < 0 ? -1 : motion.slots[node.slot].block;
        f.real = bolt.anchors[n].real;
        f.state = stateOf(bolt.anchors[n], node);
        f.anchorForce = node.bond.force;
        f.slip = node.bond.slip;
        addBondLimits(bolt.anchors[n], motion, node, f);
        if (n < motion.elements.size()) {
            const BoltElementState& e = motion.elements[n];
            f.axialForce = e.axialForce;
            f.shearForce = e.shearForce;
            f.moment = -e.moment1;
            f.ruptured = e.ruptured;
        } else {
            f.axialForce = motion.plateNormal;
            f.shearForce = motion.plateShear;
            f.moment = motion.elements.back().moment2;
        }
        frame.nodes.push_back(f);
    }
    return frame;
}

}  // namespace keyblock
