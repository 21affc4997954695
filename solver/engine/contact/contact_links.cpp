// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A corner before an edge as two links: the gap, which only pushes, and the
// slip, which friction holds up to its limit. With an augmented Lagrangian the
// springs only find the forces and store nothing.
#include "solver/engine/contact/contacts.h"
#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

/// A joint with a stiffness of its own gives way by it; other contacts need not give way to carry.
bool augmented(const Model& model, const Contact& c) {
    return model.analysis.contact == ContactMethod::AugmentedLagrangian &&
           !(model.joints[c.joint].normalStiffness && c.length > 0.0);
}

/// Where normal and shear spring of a contact carry nothing: gap and slip [m].
std::pair<double, double> zeroPoints(const Contact& c, const ContactSprings& k) {
    return {c.gapOffset + (k.normal > 0.0 ? c.normalMultiplier / k.normal : 0.0),
            c.slipOffset - (k.shear > 0.0 ? c.shearMultiplier / k.shear : 0.0)};
}

/// Blocks in the middle of the step that they make or, as far as that is not known, would make at the speed they have;
/// as rigid bodies: strain rates may ring from step to step and say nothing of what comes.
std::vector<BlockMotion> halfway(const Model& model, const State& state, double ahead, const Eigen::VectorXd* path) {
    std::vector<BlockMotion> blocks = state.blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (model.blocks[i].fixed) continue;
        Vector6 way = ahead * blocks[i].velocity;
        if (path) way = 0.5 * path->segment<6>(6 * static_cast<Eigen::Index>(i));
        way.tail<3>().setZero();
        moveBlock(model.blocks[i], blocks[i], way);
    }
    return blocks;
}

class ContactLinks {
public:
    ContactLinks(const Model& model, const State& state, const std::vector<BlockMotion>& halfway, bool frictionLocked,
                 StepProblem& problem)
        : model_(model), state_(state), halfway_(halfway), frictionLocked_(frictionLocked), problem_(problem) {}

    void add(int index) {
        const Contact& c = state_.contacts[static_cast<std::size_t>(index)];
        const BlockMotion &a = halfway_[c.blockA], &b = halfway_[c.blockB];
        const Point& corner = a.corners[c.corner];
        const Edge edge = edgeOf(b.corners, c.edge);
        const Eigen::Matrix<double, 2, 6> ta = displacementMatrix(a, corner), tb = displacementMatrix(b, corner);
        const auto link = [&](LinkKind kind, const Point& direction, double strain) -> Link& {
            Link& added = problem_.links.emplace_back();
            added.kind = kind;
            added.owner = index;
            added.a = c.blockA;
            added.b = c.blockB;
            added.ga = ta.transpose() * direction;
            added.gb = -tb.transpose() * direction;
            added.strain = strain;
            return added;
        };
        const ContactSprings k = contactSprings(model_, c);
        const auto [open, free] = zeroPoints(c, k);
        const bool rigid = augmented(model_, c);
        Link& normal = link(LinkKind::Normal, edge.outward, gapOf(state_.blocks, c));
        normal.law = {c.bonded ? LawKind::Linear : LawKind::Gap, k.normal, open, 0.0, nullptr, {}, 1.0, rigid};
        if (!problem_.openings.empty()) normal.shift = c.dilation - openingOf(problem_.openings, c);
        const bool locked = frictionLocked_ || c.bonded;
        const double limit = frictionLocked_ ? std::numeric_limits<double>::infinity() : c.limit;
        Link& friction = link(LinkKind::Friction, edge.along, slipOf(state_.blocks, c));
        friction.law = {locked ? LawKind::Linear : LawKind::Capped, k.shear, free, limit, nullptr, {}, 1.0, rigid};
        const int at = static_cast<int>(problem_.links.size()) - 1;
        if (!locked) problem_.limitPairs.push_back({at, at - 1, frictionOf(model_, c)});
    }

private:
    const Model& model_;
    const State& state_;
    const std::vector<BlockMotion>& halfway_;
    bool frictionLocked_;
    StepProblem& problem_;
};

}  // namespace

ContactSprings contactSprings(const Model& model, const Contact& c) {
    const double penalty = model.analysis.penaltyRatio * model.thickness *
                           std::min(model.blocks[c.blockA].youngsModulus, model.blocks[c.blockB].youngsModulus);
    const JointModel& joint = model.joints[c.joint];
    const double face = c.length * model.thickness;
    ContactSprings k;
    k.normal = joint.normalStiffness && face > 0.0 ? *joint.normalStiffness * face : penalty;
    k.shear = joint.shearStiffness && face > 0.0 ? *joint.shearStiffness * face : model.analysis.shearRatio * k.normal;
    return k;
}

double frictionOf(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    return c.slipped ? joint.tanResidual : joint.tanPhi;
}

void carryNormal(const Model& model, Contact& c, double strain, double force) {
    const double k = contactSprings(model, c).normal;
    c.normalMultiplier = augmented(model, c) ? force : 0.0;
    c.gapOffset = strain + (k > 0.0 ? (force - c.normalMultiplier) / k : 0.0);
}

void carryShear(const Model& model, Contact& c, double strain, double force) {
    const double k = contactSprings(model, c).shear;
    c.shearMultiplier = augmented(model, c) ? force : 0.0;
    c.slipOffset = strain - (k > 0.0 ? (force - c.shearMultiplier) / k : 0.0);
}

ContactForces forcesNow(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const ContactSprings k = contactSprings(model, c);
    const auto [open, free] = zeroPoints(c, k);
    const double normal = std::max(0.0, k.normal * (open - gapOf(blocks, c)));
    const double most = frictionOf(model, c) * normal;
    return {normal, std::clamp(k.shear * (slipOf(blocks, c) - free), -most, most)};
}

void addForces(const Model& model, Contact& c, const ContactForces& more) {
    if (augmented(model, c)) {
        c.normalMultiplier += more.normal;
        c.shearMultiplier += more.shear;
        return;
    }
    const ContactSprings k = contactSprings(model, c);
    c.gapOffset += more.normal / k.normal;
    if (k.shear > 0.0) c.slipOffset -= more.shear / k.shear;
}

double contactEnergy(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    if (augmented(model, c)) return 0.0;
    const ContactSprings k = contactSprings(model, c);
    const auto [open, free] = zeroPoints(c, k);
    const double limit = c.bonded ? std::numeric_limits<double>::infinity() : c.limit;
    const Law normal{c.bonded ? LawKind::Linear : LawKind::Gap, k.normal, open, 0.0, nullptr, {}, 1.0, false};
    const Law friction{LawKind::Capped, k.shear, free, limit, nullptr, {}, 1.0, false};
    return storedEnergy(normal, respond(normal, gapOf(blocks, c)).force) +
           storedEnergy(friction, respond(friction, slipOf(blocks, c)).force);
}

void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem, double ahead,
                     const Eigen::VectorXd* path) {
    const bool on = ahead > 0.0 || path;
    const std::vector<BlockMotion> moved = on ? halfway(model, state, ahead, path) : std::vector<BlockMotion>{};
    ContactLinks links(model, state, on ? moved : state.blocks, frictionLocked, problem);
    for (std::size_t i = 0; i < state.contacts.size(); ++i) links.add(static_cast<int>(i));
}

}  // namespace keyblock
