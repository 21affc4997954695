// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/anchor.h"

#include "solver/engine/bolt/slot_line.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double flatRockTangent = 1e-9;  // of the spring stiffness: tangent for Newton's method while rock crushes
constexpr double leastEmbedded = 1e-12;  // [m]: a shorter embedded length carries no force
constexpr double slidingShare = 1e-6;  // of the limit: a point whose force is lower by more than this sticks

double tributaryLength(const BoltModel& bolt, int n) {
    const double before = n > 0 ? bolt.elements[n - 1].length : 0.0;
    const double after = n < static_cast<int>(bolt.elements.size()) ? bolt.elements[n].length : 0.0;
    return 0.5 * (before + after);
}

/// Limits the normal force: rock or grout crushes when the pressure on the bar's diameter reaches its strength.
void addCrushing(const BoltStep& step, Law& law, int n, int block) {
    const auto& strength = step.model.joints[step.model.blocks[block].jointMaterial].crushingStrength;
    if (!strength) return;
    const double length = step.bolt.normalPer == Per::Length ? 1.0 : tributaryLength(step.bolt, n);
    law.kind = LawKind::Capped;
    law.limit = *strength * step.bolt.diameter * length;
    law.leastTangent = flatRockTangent;
}

void setSlipLaw(const AnchorModel& anchor, const BoltNode& node, const BoltMotion& motion, Law& law) {
    const NodeBond& bond = node.bond;
    law.stiffness = anchor.stiffness;
    if (anchor.curve) {
        law.kind = LawKind::Curve;
        law.curve = curveNow(anchor, motion);
        law.state = bond.curve;
    } else if (bond.bonded) {
        law.kind = LawKind::Linear;
    } else if (!anchor.restick) {
        law.kind = LawKind::Constant;
        law.limit = bond.keptForce;
    } else {
        law.kind = LawKind::Capped;
        law.offset = bond.offset;
        law.limit = slidingLimit(anchor, node, motion.strength.bond);
    }
}

/// True if the force is at the friction limit, or on the curve itself rather than on an unloading branch.
bool slides(const Law& law, const BackboneState& curve, double force) {
    if (law.kind != LawKind::Capped && law.kind != LawKind::Curve) return false;
    const double limit = law.kind == LawKind::Curve ? yieldForce(*law.curve, curve.accumulated) : law.limit;
    return std::abs(force) >= (1.0 - slidingShare) * limit;
}

/// The bond fails: the point slides with its residual strength or, if it has none, carries nothing.
void debond(const AnchorModel& anchor, double strengthFactor, BoltNode& node) {
    NodeBond& bond = node.bond;
    bond.bonded = false;
    if (anchor.curve) {  // the curve continues
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

/// The force of a point that does not re-stick is constant. When sliding reverses, this force acts in the direction of
/// motion, like a dead load, and its work is counted as that of a load.
void accountKeptForce(const NodeBond& bond, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    const double work = law.share * law.limit * (solved.strain + bond.slip);
    if (work < 0.0) {
        energy.external -= work;
        return;
    }
    energy.friction += work;
    motion.bondEnergy += work;
}

void acceptSlip(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    NodeBond& bond = motion.nodes[solved.link.part].bond;
    if (law.kind == LawKind::Curve) {
        energy.friction += law.share * solved.plasticWork;
        motion.bondEnergy += law.share * solved.plasticWork;
        bond.curve = solved.curve;
    }
    if (law.kind == LawKind::Constant) accountKeptForce(bond, motion, energy, solved);
    bond.force = -solved.force * bond.share;
    bond.slip = -solved.strain;
    bond.sliding = !bond.bonded && slides(law, solved.curve, solved.force);
}

/// A point that slid is locked at its present position, like a contact; one that stuck stays locked where it was.
void relockSlip(const State& state, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    if (law.kind != LawKind::Capped || law.stiffness <= 0.0) return;
    double slid = 0.0;
    if (reachesLimit(law, solved.force)) {
        BoltNode& node = motion.nodes[solved.link.part];
        node.bond.offset = alongSlot(slotLine(state, motion.slots[node.slot]), node) - solved.force / law.stiffness;
        slid = node.bond.offset - law.offset;
    }
    const double work = law.share * solved.slipForce * slid;
    energy.friction += work;
    motion.bondEnergy += work;
}

/// Moves the zero point across the slot after rock was crushed, so that only the elastic displacement remains.
void relockNormal(const State& state, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    if (law.kind != LawKind::Capped || std::abs(solved.force) < law.limit) return;
    BoltNode& node = motion.nodes[solved.link.part];
    const double elastic = solved.force / law.stiffness;
    node.normalOffset = offSlot(slotLine(state, motion.slots[node.slot]), node) - elastic;
    const double work = law.share * solved.slipForce * (node.normalOffset - law.offset);
    energy.plastic += work;
    motion.plasticEnergy += work;
}

}  // namespace

const Backbone* curveNow(const AnchorModel& anchor, const BoltMotion& motion) {
    if (!anchor.curve) return nullptr;
    return motion.strength.bond != 1.0 && anchor.dynamicCurve ? &*anchor.dynamicCurve : &*anchor.curve;
}

double slidingLimit(const AnchorModel& anchor, const BoltNode& node, double strengthFactor) {
    const double cohesive = strengthFactor * anchor.residual;
    if (anchor.tanPhi == 0.0 || node.bond.share <= 0.0) return cohesive;
    return cohesive + anchor.tanPhi * std::abs(node.normalForce) / node.bond.share;
}

std::optional<double> bondStrength(const AnchorModel& anchor, const BoltNode& node, double strengthFactor) {
    if (!anchor.strength) return std::nullopt;
    return strengthFactor * *anchor.strength * node.bond.share + anchor.tanPhi * std::abs(node.normalForce);
}

void addAnchorLinks(BoltStep& step, int n) {
    const BoltNode& node = step.motion.nodes[n];
    const Slot& slot = step.motion.slots[node.slot];
    const SlotLine& line = step.lineOf(node.slot);
    if (node.normalShare > 0.0) {
        Link& l = step.toRock(LinkKind::AnchorNormal, n, slot.block, line.across, offSlot(line, node),
                              step.bolt.share * node.normalShare);
        l.law.stiffness = step.bolt.normalStiffness;
        l.law.offset = node.normalOffset;
        addCrushing(step, l.law, n, slot.block);
    }
    const AnchorModel& anchor = step.bolt.anchors[n];
    if (!anchor.real || node.bond.gone || node.bond.share <= 0.0) return;
    const int normalAt = node.normalShare > 0.0 ? step.last() : -1;
    Link& l = step.toRock(LinkKind::AnchorSlip, n, slot.block, line.along, alongSlot(line, node),
                          step.bolt.share * node.bond.share);
    setSlipLaw(anchor, node, step.motion, l.law);
    if (l.law.kind != LawKind::Capped || anchor.tanPhi == 0.0 || normalAt < 0) return;
    step.problem.limitPairs.push_back({step.last(), normalAt, anchor.tanPhi * node.normalShare / node.bond.share,
                                       step.motion.strength.bond * anchor.residual, LimitPair::Rule::Clamp});
}

bool ofAnchor(LinkKind kind) { return kind == LinkKind::AnchorSlip || kind == LinkKind::AnchorNormal; }

void acceptAnchor(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    if (solved.link.kind == LinkKind::AnchorSlip) {
        acceptSlip(motion, energy, solved);
        return;
    }
    BoltNode& node = motion.nodes[solved.link.part];
    node.normalForce = solved.force * node.normalShare;
}

void relockAnchor(const State& state, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    if (solved.link.kind == LinkKind::AnchorSlip) relockSlip(state, motion, energy, solved);
    else relockNormal(state, motion, energy, solved);
}

bool ofAnchor(LimitKind kind) { return kind == LimitKind::Bond || kind == LimitKind::CurveEnd; }

void addAnchorLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int n, std::vector<Limit>& limits) {
    const BoltNode& node = motion.nodes[n];
    const AnchorModel& anchor = bolt.anchors[n];
    if (!anchor.real || node.slot < 0 || node.bond.gone || node.bond.share <= leastEmbedded) return;
    const auto add = [&](LimitKind kind, double ratio) { limits.push_back({kind, owner, n, ratio}); };
    if (const Backbone* curve = curveNow(anchor, motion)) {
        if (anchor.curveEnds) add(LimitKind::CurveEnd, std::abs(node.bond.slip) / curve->lastStrain);
        const double first = curve->force.front() / curve->modulus;
        if (node.bond.bonded) add(LimitKind::Bond, std::abs(node.bond.slip) / first);
    } else if (const auto strength = bondStrength(anchor, node, motion.strength.bond)) {
        if (node.bond.bonded) add(LimitKind::Bond, std::abs(node.bond.force) / *strength);
    }
}

bool anchorChangesForces(const AnchorModel& anchor, const Limit& limit) {
    if (limit.kind != LimitKind::Bond || limit.ratio > 1.0 + tieShare) return true;
    const bool goesOn = anchor.curve || (anchor.strength && anchor.residual >= *anchor.strength);
    return !goesOn || anchor.boltLost;
}

void releaseAnchor(const AnchorModel& anchor, const Limit& limit, BoltMotion& motion) {
    if (limit.kind == LimitKind::Bond) {
        debond(anchor, motion.strength.bond, motion.nodes[limit.part]);
        return;
    }
    NodeBond& bond = motion.nodes[limit.part].bond;
    bond.bonded = bond.sliding = false;
    bond.gone = true;
    bond.force = 0.0;
}

void loseAnchor(BoltNode& node) {
    node.normalForce = 0.0;
    node.bond.bonded = false;
    node.bond.gone = true;
    node.bond.sliding = false;
    node.bond.force = 0.0;
}

bool sticksAgain(const BoltNode& before, const BoltNode& after) {
    return before.bond.sliding && !after.bond.sliding && !after.bond.gone && after.slot >= 0 &&
           after.slot == before.slot;
}

void enterRock(const AnchorModel& anchor, const AnchorNeighbour* neighbour, NodeBond& bond) {
    if (!anchor.canFail || anchor.curveEnds) bond.gone = true;
    if (anchor.curve) bond.curve.accumulated = anchor.curve->plastic.back();
    if (!neighbour || anchor.per != Per::Length || neighbour->anchor.entry != anchor.entry) return;
    const NodeBond& beside = neighbour->bond;
    if (beside.share <= 0.0) return;
    const double most = anchor.curve ? yieldForce(*anchor.curve, bond.curve.accumulated) : anchor.residual;
    const double force = std::clamp(-beside.force / beside.share, -most, most);
    bond.keptForce = force;
    if (anchor.curve) bond.curve.plastic = -force / anchor.curve->modulus;
    else if (anchor.stiffness > 0.0) bond.offset = -force / anchor.stiffness;
}

void leaveRock(const AnchorModel& anchor, BoltNode& node) {
    if (node.bond.bonded) node.bond.keptForce = node.bond.force < 0.0 ? anchor.residual : -anchor.residual;
    node.slot = -1;
    node.normalForce = 0.0;
    node.bond.bonded = node.bond.sliding = false;
    node.bond.force = 0.0;
    node.bond.slip = 0.0;
}

}  // namespace keyblock
