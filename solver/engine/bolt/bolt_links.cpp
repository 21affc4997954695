// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Links of the shank, the anchored points and the plate of one bolt.
//
// A spring between a node and the rock acts at the node's own place on both: the
// block's displacement there is T(x)·D. So the pair of forces is collinear and
// gives no couple (the paper's eq. 26 and 30 reach the same to first order).
#include "solver/engine/stage/step_build.h"

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double flatTangent = 1e-9;  // of the spring: told to Newton where a hinge turns or rock crushes

class BoltLinks {
public:
    BoltLinks(const Model& model, const State& state, int bolt, StepProblem& problem)
        : model_(model), state_(state), bolt_(model.bolts[bolt]), motion_(state.bolts[bolt]), problem_(problem),
          index_(bolt), firstBody_(problem.blocks + model.bolts[bolt].firstNode) {}

    void add() {
        for (int e = 0; e < static_cast<int>(motion_.elements.size()); ++e)
            if (!motion_.elements[e].ruptured) addElement(e);
        for (int n = 0; n < static_cast<int>(motion_.nodes.size()); ++n)
            if (motion_.nodes[n].slot >= 0) addNode(n);
        if (motion_.plateHolds) addPlate();
    }

private:
    Link& link(LinkKind kind, int part, double strain, double share) {
        Link& l = problem_.links.emplace_back();
        l.kind = kind;
        l.owner = index_;
        l.part = part;
        l.strain = strain;
        l.law.share = share;
        return l;
    }

    /// A link between a node and the block of a slot or plate, along `direction`.
    Link& toRock(LinkKind kind, int node, int block, const Point& direction, double strain, double share) {
        Link& l = link(kind, node, strain, share);
        l.a = firstBody_ + node;
        l.b = block;
        l.ga.head<2>() = direction;
        l.gb = -displacementMatrix(state_.blocks[block], motion_.nodes[node].x).transpose() * direction;
        return l;
    }

    /// A link between the two ends of an element.
    Link& ofElement(LinkKind kind, int e, double strain, double share, const Eigen::Vector3d& g1,
                    const Eigen::Vector3d& g2) {
        Link& l = link(kind, e, strain, share);
        l.a = firstBody_ + e + 1;
        l.b = firstBody_ + e;
        l.ga.head<3>() = g2;
        l.gb.head<3>() = g1;
        return l;
    }

    void addElement(int e) {
        const BoltElement& element = bolt_.elements[e];
        const BeamSection& section = bolt_.section;
        const double length = element.length;
        const BeamStrains s = strainsOf(bolt_, motion_, e);

        const Eigen::Vector3d stretch(s.along.x() / length, s.along.y() / length, 0.0);
        Link& axial = ofElement(LinkKind::Axial, e, s.elongation / length, bolt_.share * section.area * length, -stretch,
                                stretch);
        axial.law.kind = bolt_.steel ? LawKind::Curve : LawKind::Linear;
        axial.law.stiffness = section.youngsModulus;
        axial.law.curve = steelNow(bolt_, motion_);
        axial.law.state = motion_.elements[e].steel;
        const double stress = respond(axial.law, axial.strain).force, tension = section.area * stress;

        const Eigen::Vector3d sideways(s.across.x(), s.across.y(), 0.0);
        if (tension > 0.0) {  // the chord turns against the tension it carries
            Link& chord = ofElement(LinkKind::Chord, e, 0.0, bolt_.share, -sideways, sideways);
            chord.law.stiffness = tension / s.length;
        }
        if (!bolt_.bends) return;
        const Eigen::Vector3d turn(0.0, 0.0, 1.0 / std::numbers::sqrt2);
        Link& bend = ofElement(LinkKind::Bend, e, s.p1, bolt_.share, turn, -turn);
        bend.law.stiffness = bendStiffness(bolt_, e);
        if (bolt_.hinges) addHinge(bend.law, motion_.elements[e].hingeBend, e);
        const Eigen::Vector3d chordTurn = std::numbers::sqrt2 / s.length * sideways;
        Link& shear = ofElement(LinkKind::Shear, e, s.p2, bolt_.share, turn + chordTurn, turn - chordTurn);
        shear.law.stiffness = 6.0 * section.youngsModulus * section.secondMoment /
                              ((1.0 + shearModifier(section, length, element.shears)) * length);
        if (bolt_.hinges) addHinge(shear.law, motion_.elements[e].hingeSway, e);
    }

    /// The limit of both parts of the moment falls with the square of the axial stress over the first yield stress.
    void addHinge(Law& law, double turned, int e) {
        law.kind = LawKind::Capped;
        law.offset = turned;
        law.leastTangent = flatTangent;
        law.limit = hingeLimit(bolt_, motion_, e);
    }

    /// Rock or grout crushes where the bar's pressure on its diameter reaches their strength.
    void addCrushing(Law& law, int n, int block) {
        const auto& strength = model_.joints[model_.blocks[block].jointMaterial].crushingStrength;
        if (!strength) return;
        const double length = bolt_.normalPer == Per::Length ? 1.0 : tributaryLength(n);
        law.kind = LawKind::Capped;
        law.limit = *strength * bolt_.diameter * length;
        law.leastTangent = flatTangent;
    }

    double tributaryLength(int n) const {
        const double before = n > 0 ? bolt_.elements[n - 1].length : 0.0;
        const double after = n < static_cast<int>(bolt_.elements.size()) ? bolt_.elements[n].length : 0.0;
        return 0.5 * (before + after);
    }

    void addNode(int n) {
        const BoltNode& node = motion_.nodes[n];
        const Slot& slot = motion_.slots[node.slot];
        const SlotLine line = slotLine(state_, slot);
        if (node.normalShare > 0.0) {
            Link& l = toRock(LinkKind::AnchorNormal, n, slot.block, line.across, offSlot(line, node),
                             bolt_.share * node.normalShare);
            l.law.stiffness = bolt_.normalStiffness;
            l.law.offset = node.normalOffset;
            addCrushing(l.law, n, slot.block);
        }
        const AnchorModel& anchor = bolt_.anchors[n];
        if (!anchor.real || node.bond.gone || node.bond.share <= 0.0) return;
        const int normalAt = node.normalShare > 0.0 ? last() : -1;
        Link& l = toRock(LinkKind::AnchorSlip, n, slot.block, line.along, alongSlot(line, node),
                         bolt_.share * node.bond.share);
        setSlipLaw(anchor, node, l.law);
        if (l.law.kind != LawKind::Capped || anchor.tanPhi == 0.0 || normalAt < 0) return;
        problem_.limitPairs.push_back({last(), normalAt, anchor.tanPhi * node.normalShare / node.bond.share,
                                       motion_.strengthFactor * anchor.residual, LimitPair::Rule::Clamp});
    }

    void setSlipLaw(const AnchorModel& anchor, const BoltNode& node, Law& law) const {
        const NodeBond& bond = node.bond;
        law.stiffness = anchor.stiffness;
        if (anchor.curve) {
            law.kind = LawKind::Curve;
            law.curve = curveNow(anchor, motion_);
            law.state = bond.curve;
        } else if (bond.bonded) {
            law.kind = LawKind::Linear;
        } else if (!anchor.restick) {
            law.kind = LawKind::Constant;
            law.limit = bond.keptForce;
        } else {
            law.kind = LawKind::Capped;
            law.offset = bond.offset;
            law.limit = slidingLimit(anchor, node, motion_.strengthFactor);
        }
    }

    void addPlate() {
        const PlateModel& plate = bolt_.plate;
        const BlockMotion& rock = state_.blocks[plate.block];
        const int head = static_cast<int>(motion_.nodes.size()) - 1;
        const Point place = materialPoint(rock, plate.place);
        const Point along = (materialPoint(rock, plate.place + plate.along) - place).normalized();
        const Point away = motion_.nodes[head].x - place;
        Law& normal = toRock(LinkKind::PlateNormal, head, plate.block, along, along.dot(away), bolt_.share).law;
        if (motion_.tensioning) {
            normal.kind = LawKind::Constant;
            normal.limit = -bolt_.pretension;
        } else {
            normal.stiffness = plate.normalStiffness;
            normal.offset = motion_.plateOffset;
        }
        const Point across = turnLeft(along);
        Law& shear = toRock(LinkKind::PlateShear, head, plate.block, across, across.dot(away), bolt_.share).law;
        shear.stiffness = plate.shearStiffness;
        shear.offset = motion_.plateShearOffset;
    }

    int last() const { return static_cast<int>(problem_.links.size()) - 1; }

    const Model& model_;
    const State& state_;
    const BoltModel& bolt_;
    const BoltMotion& motion_;
    StepProblem& problem_;
    int index_;
    int firstBody_;
};

}  // namespace

SlotLine slotLine(const State& state, const Slot& slot) {
    SlotLine line;
    const BlockMotion& rock = state.blocks[slot.block];
    line.p2 = materialPoint(rock, slot.p2);
    const Point chord = materialPoint(rock, slot.p3) - line.p2;
    line.length = chord.norm();
    line.along = chord / line.length;
    line.across = turnLeft(line.along);
    return line;
}

double offSlot(const SlotLine& line, const BoltNode& node) { return line.across.dot(node.x - line.p2); }

double alongSlot(const SlotLine& line, const BoltNode& node) {
    return line.along.dot(node.x - line.p2) - node.bond.place * line.length;
}

const Backbone* steelNow(const BoltModel& bolt, const BoltMotion& motion) {
    if (!bolt.steel) return nullptr;
    return motion.strengthFactor != 1.0 && bolt.dynamicSteel ? &*bolt.dynamicSteel : &*bolt.steel;
}

const Backbone* curveNow(const AnchorModel& anchor, const BoltMotion& motion) {
    if (!anchor.curve) return nullptr;
    return motion.strengthFactor != 1.0 && anchor.dynamicCurve ? &*anchor.dynamicCurve : &*anchor.curve;
}

double slidingLimit(const AnchorModel& anchor, const BoltNode& node, double strengthFactor) {
    const double cohesive = strengthFactor * anchor.residual;
    if (anchor.tanPhi == 0.0 || node.bond.share <= 0.0) return cohesive;
    return cohesive + anchor.tanPhi * std::abs(node.normalForce) / node.bond.share;
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

void addBoltLinks(const Model& model, const State& state, int bolt, StepProblem& problem) {
    if (acts(state.bolts[bolt])) BoltLinks(model, state, bolt, problem).add();
}

}  // namespace keyblock
