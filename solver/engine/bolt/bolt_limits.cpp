// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt_limits.h"

#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double leastShare = 1e-12;  // [m] embedded: less holds nothing
constexpr double leastMoment = 1e-3;  // of the hinge's moment without axial force: a straight pull makes no hinge

double squared(double x) { return x * x; }

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
        if (const Backbone* curve = curveNow(anchor, motion_)) {
            if (anchor.curveEnds) add(LimitKind::CurveEnd, n, std::abs(node.bond.slip) / curve->lastStrain);
            const double first = curve->force.front() / curve->modulus;
            if (node.bond.bonded) add(LimitKind::Bond, n, std::abs(node.bond.slip) / first);
        } else if (const auto strength = bondStrength(anchor, node, motion_.strengthFactor)) {
            if (node.bond.bonded) add(LimitKind::Bond, n, std::abs(node.bond.force) / *strength);
        }
    }

    void addElement(int e) {
        const BoltElementState& element = motion_.elements[e];
        if (const Backbone* steel = steelNow(bolt_, motion_)) {
            const double first = steel->force.front() / steel->modulus;
            const bool yields = steel->force.size() > 1;
            if (yields && !element.yielded) add(LimitKind::Yield, e, std::abs(element.strain) / first);
            if (bolt_.hinges && !element.hinged) addHinge(e);
            add(LimitKind::TensileRupture, e, element.strain / steel->lastStrain);
        }
        if (bolt_.interacts)
            add(LimitKind::Interaction, e, std::sqrt(utilisationOf(bolt_, motion_, e).forces));
        else if (bolt_.shearStrength > 0.0)
            add(LimitKind::ShearRupture, e,
                std::abs(element.shearForce) / (motion_.strengthFactor * bolt_.shearStrength));
    }

    /// By the moment that the element would have as an elastic one under the limit it had, and by the one that it has
    /// under the limit that its axial force leaves it now. Without a limit to speak of, ends turn as they like: then
    /// their rotation says nothing (theory, "Plastic hinges").
    void addHinge(int e) {
        const BoltElementState& element = motion_.elements[e];
        const double least = leastMoment * hingeForce(bolt_, motion_);
        const double elastic = bendStiffness(bolt_, e) * std::abs(element.bend);
        const double reached = element.bendLimit > least ? elastic / element.bendLimit : 0.0;
        const double left = std::max(hingeLimit(bolt_, motion_, e), least);
        add(LimitKind::Hinge, e, std::max(reached, std::min(elastic, element.bendLimit) / left));
    }

    void addPlate() {
        const PlateModel& plate = bolt_.plate;
        const double normal = plate.normalStrength ? std::abs(motion_.plateNormal) / *plate.normalStrength : 0.0;
        const double shear = plate.shearStrength ? std::abs(motion_.plateShear) / *plate.shearStrength : 0.0;
        add(LimitKind::Plate, static_cast<int>(motion_.nodes.size()) - 1,
            std::max(normal, shear) / motion_.strengthFactor);
    }

    void add(LimitKind kind, int part, double ratio) { limits_.push_back({kind, index_, part, ratio}); }

    const BoltModel& bolt_;
    const BoltMotion& motion_;
    int index_;
    std::vector<Limit>& limits_;
};

}  // namespace

void addBoltLimits(const Model& model, const State& state, int bolt, std::vector<Limit>& limits) {
    if (acts(state.bolts[bolt])) BoltLimits(model, state, bolt, limits).add();
}

std::optional<double> bondStrength(const AnchorModel& anchor, const BoltNode& node, double strengthFactor) {
    if (!anchor.strength) return std::nullopt;
    return strengthFactor * *anchor.strength * node.bond.share + anchor.tanPhi * std::abs(node.normalForce);
}

bool boltChangesForces(const Model& model, const Limit& limit) {
    if (limit.kind == LimitKind::Yield || limit.kind == LimitKind::Hinge) return false;
    if (limit.kind != LimitKind::Bond || limit.ratio > 1.0 + tieShare) return true;
    const AnchorModel& anchor = model.bolts[limit.owner].anchors[limit.part];
    const bool goesOn = anchor.curve || (anchor.strength && anchor.residual >= *anchor.strength);
    return !goesOn || anchor.boltLost;
}

Utilisation utilisationOf(const BoltModel& bolt, const BoltMotion& motion, int e) {
    if (bolt.tensileStrength <= 0.0) return {};
    const BoltElementState& element = motion.elements[e];
    const double factor = motion.strengthFactor;
    const double moment = std::max(std::abs(element.moment1), std::abs(element.moment2));
    const double plastic = factor * bolt.plasticModulus * bolt.tensileStrength / bolt.section.area;
    Utilisation u;
    u.forces = squared(element.axialForce / (factor * bolt.tensileStrength));
    if (bolt.shearStrength > 0.0) u.forces += squared(element.shearForce / (factor * bolt.shearStrength));
    u.withMoment = u.forces + moment / plastic;
    return u;
}

}  // namespace keyblock
