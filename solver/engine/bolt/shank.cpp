// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/shank.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double flatHingeTangent = 1e-9;  // of the spring stiffness: tangent for Newton's method while a hinge rotates
constexpr double leastMoment = 1e-3;  // of the hinge moment at zero axial force: pure tension forms no hinge

double squared(double x) { return x * x; }

/// The limit of both parts of the moment falls with the square of the ratio of the axial stress to the first yield
/// stress.
void addHinge(const BoltStep& step, Law& law, double turned, int e) {
    law.kind = LawKind::Capped;
    law.offset = turned;
    law.leastTangent = flatHingeTangent;
    law.limit = hingeLimit(step.bolt, step.motion, e);
}

/// Utilisation of the hinge, the larger of two ratios. The first is the moment that an elastic element would have over
/// the limit that it had. The second is the actual moment over the limit that the present axial force leaves. Below the
/// minimum moment the ends rotate freely, and their rotation has no meaning (theory, "Plastic hinges").
double hingeRatio(const BoltModel& bolt, const BoltMotion& motion, int e) {
    const BoltElementState& element = motion.elements[e];
    const double least = leastMoment * hingeForce(bolt, motion);
    const double elastic = bendStiffness(bolt, e) * std::abs(element.bend);
    const double reached = element.bendLimit > least ? elastic / element.bendLimit : 0.0;
    const double left = std::max(hingeLimit(bolt, motion, e), least);
    return std::max(reached, std::min(elastic, element.bendLimit) / left);
}

/// Whether tension or shear contributes more to the combined failure.
EventKind largerPart(const BoltModel& bolt, const BoltElementState& element) {
    const double tension = std::abs(element.axialForce) / bolt.tensileStrength;
    const double shear = bolt.shearStrength > 0.0 ? std::abs(element.shearForce) / bolt.shearStrength : 0.0;
    return tension >= shear ? EventKind::TensileRupture : EventKind::ShearRupture;
}

/// Moves the zero point of a hinge that rotated, so that only the elastic strain remains.
void turnHinge(double& offset, double strain, EnergyLedger& energy, BoltMotion& motion, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    offset = strain - solved.force / law.stiffness;
    const double work = law.share * solved.slipForce * (offset - law.offset);
    energy.plastic += work;
    motion.plasticEnergy += work;
}

}  // namespace

const Backbone* steelNow(const BoltModel& bolt, const BoltMotion& motion) {
    if (!bolt.steel) return nullptr;
    return motion.strength.steel != 1.0 && bolt.dynamicSteel ? &*bolt.dynamicSteel : &*bolt.steel;
}

BeamStrains strainsOf(const BoltModel& bolt, const BoltMotion& motion, int e) {
    const BoltNode& n1 = motion.nodes[e];
    const BoltNode& n2 = motion.nodes[e + 1];
    return beamStrains({n1.x, n2.x, n1.angle, n2.angle}, bolt.elements[e].length, bolt.angle);
}

double bendStiffness(const BoltModel& bolt, int e) {
    return 2.0 * bolt.section.youngsModulus * bolt.section.secondMoment / bolt.elements[e].length;
}

double hingeForce(const BoltModel& bolt, const BoltMotion& motion) {
    if (!bolt.hinges) return 0.0;
    return std::numbers::sqrt2 * bolt.plasticModulus * steelNow(bolt, motion)->force.front();
}

double hingeLimit(const BoltModel& bolt, const BoltMotion& motion, int e) {
    const double share = motion.elements[e].axialForce / (bolt.section.area * steelNow(bolt, motion)->force.front());
    return hingeForce(bolt, motion) * std::max(0.0, 1.0 - share * share);
}

Utilisation utilisationOf(const BoltModel& bolt, const BoltMotion& motion, int e) {
    if (bolt.tensileStrength <= 0.0) return {};
    const BoltElementState& element = motion.elements[e];
    const double factor = motion.strength.steel;
    const double moment = std::max(std::abs(element.moment1), std::abs(element.moment2));
    const double plastic = factor * bolt.plasticModulus * bolt.tensileStrength / bolt.section.area;
    Utilisation u;
    u.forces = squared(element.axialForce / (factor * bolt.tensileStrength));
    if (bolt.shearStrength > 0.0) u.forces += squared(element.shearForce / (factor * bolt.shearStrength));
    u.withMoment = u.forces + moment / plastic;
    return u;
}

void addShankLinks(BoltStep& step, int e) {
    const BoltElement& element = step.bolt.elements[e];
    const BeamSection& section = step.bolt.section;
    const double length = element.length;
    const BeamStrains s = strainsOf(step.bolt, step.motion, e);

    const Eigen::Vector3d stretch(s.along.x() / length, s.along.y() / length, 0.0);
    Link& axial = step.ofElement(LinkKind::Axial, e, s.elongation / length, step.bolt.share * section.area * length,
                                 -stretch, stretch);
    axial.law.kind = step.bolt.steel ? LawKind::Curve : LawKind::Linear;
    axial.law.stiffness = section.youngsModulus;
    axial.law.curve = steelNow(step.bolt, step.motion);
    axial.law.state = step.motion.elements[e].steel;
    const double stress = respond(axial.law, axial.strain).force, tension = section.area * stress;

    const Eigen::Vector3d sideways(s.across.x(), s.across.y(), 0.0);
    if (tension > 0.0) {  // the tension resists rotation of the chord
        Link& chord = step.ofElement(LinkKind::Chord, e, 0.0, step.bolt.share, -sideways, sideways);
        chord.law.stiffness = tension / s.length;
    }
    if (!step.bolt.bends) return;
    const Eigen::Vector3d turn(0.0, 0.0, 1.0 / std::numbers::sqrt2);
    Link& bend = step.ofElement(LinkKind::Bend, e, s.p1, step.bolt.share, turn, -turn);
    bend.law.stiffness = bendStiffness(step.bolt, e);
    if (step.bolt.hinges) addHinge(step, bend.law, step.motion.elements[e].hingeBend, e);
    const Eigen::Vector3d chordTurn = std::numbers::sqrt2 / s.length * sideways;
    Link& shear = step.ofElement(LinkKind::Shear, e, s.p2, step.bolt.share, turn + chordTurn, turn - chordTurn);
    shear.law.stiffness = 6.0 * section.youngsModulus * section.secondMoment /
                          ((1.0 + shearModifier(section, length, element.shears)) * length);
    if (step.bolt.hinges) addHinge(step, shear.law, step.motion.elements[e].hingeSway, e);
}

bool ofShank(LinkKind kind) {
    return kind == LinkKind::Axial || kind == LinkKind::Chord || kind == LinkKind::Bend || kind == LinkKind::Shear;
}

void acceptShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Link& link = solved.link;
    BoltElementState& e = motion.elements[link.part];
    switch (link.kind) {
        case LinkKind::Axial:
            e.strain = solved.strain;
            e.axialForce = bolt.section.area * solved.force;
            if (link.law.kind != LawKind::Curve) return;
            e.steel = solved.curve;
            energy.plastic += link.law.share * solved.plasticWork;
            motion.plasticEnergy += link.law.share * solved.plasticWork;
            return;
        case LinkKind::Bend:
            e.moment1 = solved.force;
            e.bend = solved.strain - link.law.offset;
            e.bendLimit = link.law.limit;
            return;
        case LinkKind::Shear: {  // always follows the bending link of its element
            const BeamForces forces = beamForces(e.moment1, solved.force, bolt.elements[link.part].length);
            e.moment1 = forces.moment1;
            e.moment2 = forces.moment2;
            e.shearForce = forces.shear;
            return;
        }
        default: return;
    }
}

void relockShank(const BoltModel& bolt, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Link& link = solved.link;
    const bool bend = link.kind == LinkKind::Bend;
    if (!bend && link.kind != LinkKind::Shear) return;
    if (link.law.kind != LawKind::Capped || std::abs(solved.force) < link.law.limit) return;
    BoltElementState& e = motion.elements[link.part];
    const BeamStrains strains = strainsOf(bolt, motion, link.part);
    turnHinge(bend ? e.hingeBend : e.hingeSway, bend ? strains.p1 : strains.p2, energy, motion, solved);
}

bool ofShank(LimitKind kind) {
    return kind == LimitKind::Yield || kind == LimitKind::Hinge || kind == LimitKind::TensileRupture ||
           kind == LimitKind::ShearRupture || kind == LimitKind::Interaction;
}

void addShankLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int e, std::vector<Limit>& limits) {
    const BoltElementState& element = motion.elements[e];
    if (element.ruptured) return;
    const auto add = [&](LimitKind kind, double ratio) { limits.push_back({kind, owner, e, ratio}); };
    if (const Backbone* steel = steelNow(bolt, motion)) {
        const double first = steel->force.front() / steel->modulus;
        const bool yields = steel->force.size() > 1;
        if (yields && !element.yielded) add(LimitKind::Yield, std::abs(element.strain) / first);
        if (bolt.hinges && !element.hinged) add(LimitKind::Hinge, hingeRatio(bolt, motion, e));
        add(LimitKind::TensileRupture, element.strain / steel->lastStrain);
    }
    if (bolt.interacts)
        add(LimitKind::Interaction, std::sqrt(utilisationOf(bolt, motion, e).forces));
    else if (bolt.shearStrength > 0.0)
        add(LimitKind::ShearRupture, std::abs(element.shearForce) / (motion.strength.steel * bolt.shearStrength));
}

void releaseShank(BoltMotion& motion, const Limit& limit) {
    BoltElementState& element = motion.elements[limit.part];
    if (limit.kind == LimitKind::Yield) {
        element.yielded = true;
    } else if (limit.kind == LimitKind::Hinge) {
        element.hinged = true;
    } else {
        element.ruptured = true;
        unloadElement(element);
    }
}

EventKind shankEvent(const BoltModel& bolt, const BoltMotion& motion, const Limit& limit) {
    switch (limit.kind) {
        case LimitKind::Yield: return EventKind::Yield;
        case LimitKind::Hinge: return EventKind::Hinge;
        case LimitKind::ShearRupture: return EventKind::ShearRupture;
        case LimitKind::Interaction: return largerPart(bolt, motion.elements[limit.part]);
        default: return EventKind::TensileRupture;
    }
}

void unloadElement(BoltElementState& element) {
    element.axialForce = element.shearForce = element.moment1 = element.moment2 = 0.0;
}

}  // namespace keyblock
