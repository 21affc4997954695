// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What happens to a bolt when one of its limits lets go, and what is told of it.
#include "solver/engine/bolt/bolt_limits.h"
#include "solver/engine/stage/step_build.h"

#include <cmath>

namespace keyblock {
namespace {

/// Of the two elements beside a node, the larger |N| with its sign.
double axialBeside(const BoltMotion& motion, int node) {
    double axial = 0.0;
    for (int e : {node - 1, node}) {
        if (e < 0 || e >= static_cast<int>(motion.elements.size()) || motion.elements[e].ruptured) continue;
        if (std::abs(motion.elements[e].axialForce) > std::abs(axial)) axial = motion.elements[e].axialForce;
    }
    return axial;
}

/// The point slides on with what is left, or nothing is.
void debond(const AnchorModel& anchor, double strengthFactor, BoltNode& node) {
    NodeBond& bond = node.bond;
    bond.bonded = false;
    if (anchor.curve) {  // the curve goes on
        bond.sliding = true;
        return;
    }
    bond.gone = anchor.residual <= 0.0 && anchor.tanPhi <= 0.0;
    bond.sliding = !bond.gone && anchor.restick;
    const double pull = -bond.force > 0.0 ? 1.0 : -1.0;  // sign of the law's force
    bond.keptForce = bond.gone ? 0.0 : pull * slidingLimit(anchor, node, strengthFactor);
    bond.offset = -bond.slip - bond.keptForce / anchor.stiffness;
    bond.force = -bond.keptForce * bond.share;
}

void loseBolt(BoltMotion& motion) {
    motion.lost = true;
    motion.plateHolds = false;
    motion.plateNormal = motion.plateShear = 0.0;
    for (BoltNode& node : motion.nodes) {
        node.velocity.setZero();
        node.normalForce = 0.0;
        node.bond.bonded = false;
        node.bond.gone = true;
        node.bond.sliding = false;
        node.bond.force = 0.0;
    }
    for (BoltElementState& e : motion.elements) e.axialForce = e.shearForce = e.moment1 = e.moment2 = 0.0;
}

void rupture(BoltElementState& element) {
    element.ruptured = true;
    element.axialForce = element.shearForce = element.moment1 = element.moment2 = 0.0;
}

/// Which of tension and shear has the larger part in the combined action.
EventKind largerPart(const BoltModel& bolt, const BoltElementState& element) {
    const double tension = std::abs(element.axialForce) / bolt.tensileStrength;
    const double shear = bolt.shearStrength > 0.0 ? std::abs(element.shearForce) / bolt.shearStrength : 0.0;
    return tension >= shear ? EventKind::TensileRupture : EventKind::ShearRupture;
}

EventKind eventOf(const Model& model, const State& state, const Limit& limit) {
    switch (limit.kind) {
        case LimitKind::Yield: return EventKind::Yield;
        case LimitKind::Hinge: return EventKind::Hinge;
        case LimitKind::TensileRupture: return EventKind::TensileRupture;
        case LimitKind::ShearRupture: return EventKind::ShearRupture;
        case LimitKind::Interaction:
            return largerPart(model.bolts[limit.owner], state.bolts[limit.owner].elements[limit.part]);
        case LimitKind::Plate: return EventKind::PlateLoss;
        default: return EventKind::Debonding;
    }
}

void letGo(const BoltModel& bolt, const Limit& limit, BoltMotion& motion) {
    switch (limit.kind) {
        case LimitKind::Bond: debond(bolt.anchors[limit.part], motion.strengthFactor, motion.nodes[limit.part]); break;
        case LimitKind::CurveEnd: {
            NodeBond& bond = motion.nodes[limit.part].bond;
            bond.bonded = bond.sliding = false;
            bond.gone = true;
            bond.force = 0.0;
            break;
        }
        case LimitKind::Yield: motion.elements[limit.part].yielded = true; break;
        case LimitKind::Hinge: motion.elements[limit.part].hinged = true; break;
        case LimitKind::TensileRupture:
        case LimitKind::ShearRupture:
        case LimitKind::Interaction: rupture(motion.elements[limit.part]); break;
        case LimitKind::Plate:
            motion.plateHolds = motion.tensioning = false;
            motion.plateNormal = motion.plateShear = 0.0;
            break;
        default: break;
    }
}

}  // namespace

Event boltEvent(const Model& model, const State& state, const Limit& limit, EventKind kind) {
    const BoltMotion& motion = state.bolts[limit.owner];
    Event event;
    event.kind = kind;
    event.bolt = limit.owner;
    const BoltNode& node = motion.nodes[limit.part];
    if (node.slot >= 0) event.block = motion.slots[node.slot].block;
    event.position = node.x;
    const bool ofElement = kind == EventKind::Yield || kind == EventKind::Hinge || kind == EventKind::TensileRupture ||
                           kind == EventKind::ShearRupture;
    if (ofElement) {
        event.element = limit.part;
        event.position = 0.5 * (node.x + motion.nodes[limit.part + 1].x);
        event.axialForce = motion.elements[limit.part].axialForce;
        event.shearForce = motion.elements[limit.part].shearForce;
        return event;
    }
    event.node = limit.part;
    event.axialForce = axialBeside(motion, limit.part);
    event.anchorForce = node.bond.force;
    event.slip = node.bond.slip;
    if (kind != EventKind::PlateLoss) return event;
    event.block = model.bolts[limit.owner].plate.block;
    event.axialForce = motion.plateNormal;
    event.shearForce = motion.plateShear;
    return event;
}

std::vector<Event> releaseBolt(const Model& model, State& state, const Limit& limit) {
    const BoltModel& bolt = model.bolts[limit.owner];
    BoltMotion& motion = state.bolts[limit.owner];
    std::vector<Event> events{boltEvent(model, state, limit, eventOf(model, state, limit))};
    const double held = boltEnergy(model, state, limit.owner);
    letGo(bolt, limit, motion);
    const bool anchorFails = limit.kind == LimitKind::Bond || limit.kind == LimitKind::CurveEnd;
    if (anchorFails && bolt.anchors[limit.part].boltLost) {
        events.push_back(events.front());
        events.back().kind = EventKind::BoltLoss;
        const double moving = kineticEnergy(model, state);
        loseBolt(motion);
        state.energy.released += moving - kineticEnergy(model, state);
    }
    const double released = held - boltEnergy(model, state, limit.owner);
    state.energy.released += released;
    if (anchorFails) motion.bondEnergy += released;
    return events;
}

}  // namespace keyblock
