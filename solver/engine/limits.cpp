// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/limits.h"

#include "solver/engine/contacts.h"
#include "solver/engine/step_build.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double leastShare = 1e-12;  // [m] embedded: less holds nothing
constexpr double leastFriction = 1e-12;  // of E · size · thickness: less is round-off
constexpr double leastTension = 1e-6;  // of the cohesive strength, for joints without tensile strength

class BoltLimits {
public:
    BoltLimits(const Model& model, const State& state, int bolt, std::vector<Limit>& limits)
        : bolt_(model.bolts[bolt]), motion_(state.bolts[bolt]), index_(bolt), limits_(limits) {}

    void add() {
        for (int i = 0; i < static_cast<int>(motion_.nodes.size()); ++i) {
            addNode(i);
            if (i < static_cast<int>(motion_.elements.size()) && !motion_.elements[i].ruptured) addElement(i);
        }
        if (motion_.plateHolds) addPlate();
    }

private:
    void addNode(int n) {
        const BoltNode& node = motion_.nodes[n];
        const AnchorModel& anchor = bolt_.anchors[n];
        if (!anchor.real || node.slot < 0 || node.bond.gone || node.bond.share <= leastShare) return;
        if (anchor.curve) {
            if (anchor.curveEnds) add(LimitKind::CurveEnd, n, std::abs(node.bond.slip) / anchor.curve->lastStrain);
            const double first = anchor.curve->force.front() / anchor.curve->modulus;
            if (node.bond.bonded) add(LimitKind::Bond, n, std::abs(node.bond.slip) / first);
        } else if (node.bond.bonded && anchor.strength) {
            add(LimitKind::Bond, n, std::abs(node.bond.force) / (*anchor.strength * node.bond.share));
        }
    }

    void addElement(int e) {
        const BoltElementState& element = motion_.elements[e];
        if (bolt_.steel) {
            const double first = bolt_.steel->force.front() / bolt_.steel->modulus;
            const bool yields = bolt_.steel->force.size() > 1;
            if (yields && !element.yielded) add(LimitKind::Yield, e, std::abs(element.strain) / first);
            add(LimitKind::TensileRupture, e, element.strain / bolt_.steel->lastStrain);
        }
        if (bolt_.shearStrength > 0.0)
            add(LimitKind::ShearRupture, e, std::abs(element.shearForce) / bolt_.shearStrength);
    }

    void addPlate() {
        const PlateModel& plate = bolt_.plate;
        const double normal = plate.normalStrength ? std::abs(motion_.plateNormal) / *plate.normalStrength : 0.0;
        const double shear = plate.shearStrength ? std::abs(motion_.plateShear) / *plate.shearStrength : 0.0;
        add(LimitKind::Plate, static_cast<int>(motion_.nodes.size()) - 1, std::max(normal, shear));
    }

    void add(LimitKind kind, int part, double ratio) { limits_.push_back({kind, index_, part, ratio}); }

    const BoltModel& bolt_;
    const BoltMotion& motion_;
    int index_;
    std::vector<Limit>& limits_;
};

double tensionRatio(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    const double face = c.length * model.thickness;
    const double strength = std::max(joint.tensileStrength, leastTension * joint.cohesion) * face;
    if (strength <= 0.0) return c.normalForce < 0.0 ? 1.0 / leastTension : 0.0;  // taken away by a stage
    return std::max(0.0, -c.normalForce) / strength;
}

double shearRatio(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    const double strength =
        joint.cohesion * c.length * model.thickness + std::max(0.0, c.normalForce) * joint.tanPhi;
    return strength > 0.0 ? std::abs(c.shearForce) / strength : (c.shearForce == 0.0 ? 0.0 : 1.0 / leastTension);
}

/// Friction that has a residual angle to fall to, under a force that is more than round-off.
bool holdsPeak(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    if (c.bonded || c.slipped || joint.tanResidual >= joint.tanPhi) return false;
    const double modulus = std::min(model.blocks[c.blockA].youngsModulus, model.blocks[c.blockB].youngsModulus);
    const double size = std::min(model.blocks[c.blockA].size, model.blocks[c.blockB].size);
    return c.normalForce * joint.tanPhi > leastFriction * modulus * size * model.thickness;
}

/// What the contact would carry had it not slid in its last step, over the peak: 1 where sliding begins.
double peakRatio(const Model& model, const Contact& c) {
    return (std::abs(c.shearForce) + contactSprings(model, c).shear * std::abs(c.slid)) /
           (c.normalForce * model.joints[c.joint].tanPhi);
}

/// Of the two elements beside a node, the larger |N| with its sign.
double axialBeside(const BoltMotion& motion, int node) {
    double axial = 0.0;
    for (int e : {node - 1, node}) {
        if (e < 0 || e >= static_cast<int>(motion.elements.size()) || motion.elements[e].ruptured) continue;
        if (std::abs(motion.elements[e].axialForce) > std::abs(axial)) axial = motion.elements[e].axialForce;
    }
    return axial;
}

Event boltEvent(const BoltModel& bolt, const BoltMotion& motion, const Limit& limit, EventKind kind) {
    Event event;
    event.kind = kind;
    event.bolt = limit.owner;
    const BoltNode& node = motion.nodes[limit.part];
    if (node.slot >= 0) event.block = motion.slots[node.slot].block;
    event.position = node.x;
    const bool ofElement = kind == EventKind::Yield || kind == EventKind::TensileRupture ||
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
    event.block = bolt.plate.block;
    event.axialForce = motion.plateNormal;
    event.shearForce = motion.plateShear;
    return event;
}

void debond(const Model& model, State& state, const Limit& limit) {
    const BoltModel& bolt = model.bolts[limit.owner];
    const AnchorModel& anchor = bolt.anchors[limit.part];
    NodeBond& bond = state.bolts[limit.owner].nodes[limit.part].bond;
    bond.bonded = false;
    if (anchor.curve) return;  // the curve goes on
    bond.gone = anchor.residual <= 0.0;
    const double pull = -bond.force > 0.0 ? 1.0 : -1.0;  // sign of the law's force
    bond.keptForce = pull * anchor.residual;
    bond.offset = -bond.slip - bond.keptForce / anchor.stiffness;
    bond.force = -bond.keptForce * bond.share;
}

void loseBolt(BoltMotion& motion) {
    motion.lost = true;
    motion.plateHolds = false;
    motion.plateNormal = motion.plateShear = 0.0;
    for (BoltNode& node : motion.nodes) {
        node.velocity.setZero();
        node.bond.bonded = false;
        node.bond.gone = true;
        node.bond.force = 0.0;
    }
    for (BoltElementState& e : motion.elements) e.axialForce = e.shearForce = e.moment1 = e.moment2 = 0.0;
}

void rupture(BoltElementState& element) {
    element.ruptured = true;
    element.axialForce = element.shearForce = element.moment1 = element.moment2 = 0.0;
}

std::vector<Event> releaseBolt(const Model& model, State& state, const Limit& limit, EventKind kind) {
    const BoltModel& bolt = model.bolts[limit.owner];
    BoltMotion& motion = state.bolts[limit.owner];
    std::vector<Event> events{boltEvent(bolt, motion, limit, kind)};
    const double held = boltEnergy(model, state, limit.owner);
    switch (limit.kind) {
        case LimitKind::Bond: debond(model, state, limit); break;
        case LimitKind::CurveEnd: {
            NodeBond& bond = motion.nodes[limit.part].bond;
            bond.bonded = false;
            bond.gone = true;
            bond.force = 0.0;
            break;
        }
        case LimitKind::Yield: motion.elements[limit.part].yielded = true; break;
        case LimitKind::TensileRupture:
        case LimitKind::ShearRupture: rupture(motion.elements[limit.part]); break;
        case LimitKind::Plate:
            motion.plateHolds = false;
            motion.plateNormal = motion.plateShear = 0.0;
            break;
        case LimitKind::JointBond:
        case LimitKind::PeakFriction: break;
    }
    const bool anchorFails = limit.kind == LimitKind::Bond || limit.kind == LimitKind::CurveEnd;
    if (anchorFails && bolt.anchors[limit.part].boltLost) {
        events.push_back(events.front());
        events.back().kind = EventKind::BoltLoss;
        const double moving = kineticEnergy(model, state);
        loseBolt(motion);
        state.energy.released += moving - kineticEnergy(model, state);
    }
    state.energy.released += held - boltEnergy(model, state, limit.owner);
    return events;
}

/// Friction falls to what is left of it; the joint carries that where the blocks are.
void dropFriction(const Model& model, State& state, Contact& c) {
    c.limit = std::max(0.0, c.normalForce) * frictionOf(model, c);
    const double kept = std::clamp(c.shearForce, -c.limit, c.limit);
    carryShear(model, c, slipOf(state.blocks, c), kept);
    c.shearForce = kept;
}

Event releaseJoint(const Model& model, State& state, const Limit& limit) {
    Contact& c = state.contacts[limit.owner];
    Event event;
    const bool opens = c.bonded && tensionRatio(model, c) >= shearRatio(model, c);
    event.kind = opens ? EventKind::JointOpen : EventKind::JointSlip;
    event.block = c.blockA;
    event.otherBlock = c.blockB;
    event.position = c.position;
    event.axialForce = -c.normalForce;
    event.shearForce = c.shearForce;
    event.slip = c.slip;
    state.energy.released += contactEnergy(model, state.blocks, c);
    c.bonded = false;
    c.slipped = c.slipped || !opens;
    dropFriction(model, state, c);
    state.energy.released -= contactEnergy(model, state.blocks, c);
    return event;
}

EventKind eventOf(LimitKind kind) {
    switch (kind) {
        case LimitKind::Bond:
        case LimitKind::CurveEnd: return EventKind::Debonding;
        case LimitKind::Yield: return EventKind::Yield;
        case LimitKind::TensileRupture: return EventKind::TensileRupture;
        case LimitKind::ShearRupture: return EventKind::ShearRupture;
        case LimitKind::Plate: return EventKind::PlateLoss;
        case LimitKind::JointBond: return EventKind::JointOpen;
        case LimitKind::PeakFriction: return EventKind::JointSlip;
    }
    return EventKind::Debonding;
}

}  // namespace

std::vector<Limit> heldLimits(const Model& model, const State& state) {
    std::vector<Limit> limits;
    for (std::size_t b = 0; b < model.bolts.size(); ++b)
        if (!state.bolts[b].lost) BoltLimits(model, state, static_cast<int>(b), limits).add();
    for (std::size_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        if (holdsPeak(model, c))
            limits.push_back({LimitKind::PeakFriction, static_cast<int>(i), 0, peakRatio(model, c)});
        if (!c.bonded) continue;
        limits.push_back({LimitKind::JointBond, static_cast<int>(i), 0, std::max(tensionRatio(model, c),
                                                                                 shearRatio(model, c))});
    }
    return limits;
}

std::optional<Limit> worstLimit(const std::vector<Limit>& limits, double least) {
    double largest = 0.0;
    for (const Limit& limit : limits) largest = std::max(largest, limit.ratio);
    if (largest < least) return std::nullopt;
    for (const Limit& limit : limits)
        if (limit.ratio >= largest * (1.0 - tieShare)) return limit;
    return std::nullopt;
}

bool changesForces(const Model& model, const Limit& limit) {
    if (limit.kind == LimitKind::Yield) return false;
    if (limit.kind != LimitKind::Bond || limit.ratio > 1.0 + tieShare) return true;
    const AnchorModel& anchor = model.bolts[limit.owner].anchors[limit.part];
    const bool goesOn = anchor.curve || (anchor.strength && anchor.residual >= *anchor.strength);
    return !goesOn || anchor.boltLost;
}

std::vector<Event> releaseLimit(const Model& model, State& state, const Limit& limit) {
    if (limit.kind == LimitKind::JointBond || limit.kind == LimitKind::PeakFriction)
        return {releaseJoint(model, state, limit)};
    return releaseBolt(model, state, limit, eventOf(limit.kind));
}

}  // namespace keyblock
