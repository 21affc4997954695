// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/springs.h"

#include "solver/engine/laws/law.h"
#include "solver/engine/model/edge.h"

#include <algorithm>
#include <limits>

namespace keyblock {

Point contactPoint(const std::vector<BlockMotion>& blocks, const Contact& c) {
    const std::vector<Point>& corners = blocks[c.blockA].corners;
    if (c.face.toward < 0) return corners[c.corner];
    return (1.0 - c.face.inward) * corners[c.corner] + c.face.inward * corners[c.face.toward];
}

double placeOnEdge(const std::vector<BlockMotion>& blocks, const Contact& c) {
    const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
    return edge.along.dot(contactPoint(blocks, c) - edge.start) / edge.length;
}

ContactStrains strainsOf(const std::vector<BlockMotion>& blocks, const Contact& c) {
    const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
    const Point from = contactPoint(blocks, c) - edge.start;
    return {edge.outward.dot(from), edge.along.dot(from) - c.lockPlace * edge.length};
}

double gapOf(const std::vector<BlockMotion>& blocks, const Contact& c) { return strainsOf(blocks, c).gap; }

double slipOf(const std::vector<BlockMotion>& blocks, const Contact& c) { return strainsOf(blocks, c).slip; }

bool isAugmented(const Model& model, const Contact& c) {
    return model.numerics.contact == ContactMethod::AugmentedLagrangian &&
           !(model.joints[c.joint].normalStiffness && c.length > 0.0) && c.face.toward < 0;
}

ContactSprings contactSprings(const Model& model, const Contact& c) {
    const double penalty = model.numerics.penaltyRatio * model.thickness *
                           std::min(model.blocks[c.blockA].youngsModulus, model.blocks[c.blockB].youngsModulus);
    const JointModel& joint = model.joints[c.joint];
    const double face = c.length * model.thickness;
    ContactSprings k;
    k.normal = joint.normalStiffness && face > 0.0 ? *joint.normalStiffness * face : penalty;
    k.shear = joint.shearStiffness && face > 0.0 ? *joint.shearStiffness * face : model.analysis.shearRatio * k.normal;
    return k;
}

std::pair<double, double> zeroPoints(const Contact& c, const ContactSprings& k) {
    return {c.gapOffset + (k.normal > 0.0 ? c.normalMultiplier / k.normal : 0.0),
            c.slipOffset - (k.shear > 0.0 ? c.shearMultiplier / k.shear : 0.0)};
}

double frictionOf(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    return c.slipped ? joint.tanResidual : joint.tanPhi;
}

void carryNormal(const Model& model, Contact& c, double strain, double force) {
    const double k = contactSprings(model, c).normal;
    c.normalMultiplier = isAugmented(model, c) ? force : 0.0;
    c.gapOffset = strain + (k > 0.0 ? (force - c.normalMultiplier) / k : 0.0);
}

void carryShear(const Model& model, Contact& c, double strain, double force) {
    const double k = contactSprings(model, c).shear;
    c.shearMultiplier = isAugmented(model, c) ? force : 0.0;
    c.slipOffset = strain - (k > 0.0 ? (force - c.shearMultiplier) / k : 0.0);
}

ContactForces forcesNow(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const ContactSprings k = contactSprings(model, c);
    const auto [open, free] = zeroPoints(c, k);
    const ContactStrains now = strainsOf(blocks, c);
    const double normal = std::max(0.0, k.normal * (open - now.gap));
    const double most = frictionOf(model, c) * normal;
    return {normal, std::clamp(k.shear * (now.slip - free), -most, most)};
}

void addForces(const Model& model, Contact& c, const ContactForces& more) {
    if (isAugmented(model, c)) {
        c.normalMultiplier += more.normal;
        c.shearMultiplier += more.shear;
        return;
    }
    const ContactSprings k = contactSprings(model, c);
    c.gapOffset += more.normal / k.normal;
    if (k.shear > 0.0) c.slipOffset -= more.shear / k.shear;
}

double contactEnergy(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    if (isAugmented(model, c)) return 0.0;
    const ContactSprings k = contactSprings(model, c);
    const auto [open, free] = zeroPoints(c, k);
    const double limit = c.bonded ? std::numeric_limits<double>::infinity() : c.limit;
    const Law normal{c.bonded ? LawKind::Linear : LawKind::Gap, k.normal, open, 0.0, nullptr, {}, 1.0, false};
    const Law friction{LawKind::Capped, k.shear, free, limit, nullptr, {}, 1.0, false};
    const ContactStrains now = strainsOf(blocks, c);
    return storedEnergy(normal, respond(normal, now.gap).force) +
           storedEnergy(friction, respond(friction, now.slip).force);
}

}  // namespace keyblock
