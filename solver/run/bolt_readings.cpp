// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/bolt_readings.h"

#include "solver/engine/bolt/anchor.h"
#include "solver/engine/bolt/shank.h"

#include <algorithm>
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

double ofElement(const BoltModel& bolt, const BoltMotion& motion, int element, BoltQuantity quantity) {
    const BoltElementState& e = motion.elements[element];
    switch (quantity) {
        case BoltQuantity::AxialForce: return e.axialForce;
        case BoltQuantity::ShearForce: return e.shearForce;
        case BoltQuantity::Strain: return e.strain;
        case BoltQuantity::Utilisation: return utilisationOf(bolt, motion, element).forces;
        case BoltQuantity::UtilisationWithMoment: return utilisationOf(bolt, motion, element).withMoment;
        default: return std::abs(e.moment1) > std::abs(e.moment2) ? -e.moment1 : e.moment2;
    }
}

NodeState stateOf(const AnchorModel& anchor, const BoltNode& node) {
    if (node.slot < 0) return NodeState::Free;
    if (!anchor.real || node.bond.gone) return NodeState::Gone;
    return node.bond.bonded ? NodeState::Bonded : NodeState::Slipping;
}

/// What the bond of a node can bear, at its peak and once it slides.
void addBondLimits(const AnchorModel& anchor, const BoltMotion& motion, const BoltNode& node, BoltNodeFrame& frame) {
    frame.bondStrength = bondStrengthNow(anchor, motion, node);
    if (frame.bondStrength > 0.0 && !anchor.curve)
        frame.bondResidual = slidingLimit(anchor, node, motion.strength.bond) * node.bond.share;
}

}  // namespace

double boltValueAt(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity, double s) {
    switch (quantity) {
        case BoltQuantity::AnchorForce: return motion.nodes[nodeAt(bolt, s)].bond.force;
        case BoltQuantity::Slip: return motion.nodes[nodeAt(bolt, s)].bond.slip;
        case BoltQuantity::PlateForce: return motion.plateNormal;
        case BoltQuantity::DebondedLength: return debondedLength(bolt, motion);
        case BoltQuantity::Moment: {
            const int i = elementAt(bolt, s);
            const BoltElementState& e = motion.elements[i];
            const double share = (s - bolt.s[i]) / bolt.elements[i].length;
            return (1.0 - share) * -e.moment1 + share * e.moment2;
        }
        default: return ofElement(bolt, motion, elementAt(bolt, s), quantity);
    }
}

double boltExtreme(const BoltModel& bolt, const BoltMotion& motion, BoltQuantity quantity) {
    if (quantity == BoltQuantity::PlateForce || quantity == BoltQuantity::DebondedLength)
        return boltValueAt(bolt, motion, quantity, 0.0);
    double extreme = 0.0;
    const auto take = [&](double value) {
        if (std::abs(value) > std::abs(extreme)) extreme = value;
    };
    if (quantity == BoltQuantity::AnchorForce || quantity == BoltQuantity::Slip)
        for (const BoltNode& node : motion.nodes)
            take(quantity == BoltQuantity::Slip ? node.bond.slip : node.bond.force);
    else
        for (int e = 0; e < static_cast<int>(motion.elements.size()); ++e) take(ofElement(bolt, motion, e, quantity));
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
