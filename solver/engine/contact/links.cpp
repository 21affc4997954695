// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/links.h"

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/contact_limits.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/model/edge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double leastForce = 1e-12;  // of E · size · thickness: smaller forces are round-off

/// The blocks in the middle of the step. They follow the path of the step or, where it is not known, continue at their
/// present velocity. They move as rigid bodies, because strain rates may oscillate from step to step and predict
/// nothing.
std::vector<BlockMotion> halfway(const Model& model, const State& state, double ahead, const Eigen::VectorXd* path) {
    std::vector<BlockMotion> blocks = state.blocks;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (model.blocks[i].fixed) continue;
        Vector6 way = 0.5 * expectedMove(model, state, static_cast<int>(i), {2.0 * ahead, 0.5, path});
        way.tail<3>().setZero();
        moveBlock(model.blocks[i], blocks[i], way);
    }
    return blocks;
}

class ContactLinks {
public:
    ContactLinks(const Model& model, const State& state, const std::vector<BlockMotion>& halfway, bool frictionLocked,
                 StepProblem& problem)
        : model_(model), state_(state), halfway_(halfway), frictionLocked_(frictionLocked), problem_(problem) {
        frames_.reserve(halfway.size());
        for (const BlockMotion& block : halfway) frames_.push_back(frameOf(block));
    }

    void add(int index) {
        const Contact& c = state_.contacts[index];
        const Point place = contactPoint(halfway_, c);
        const Edge edge = edgeOf(halfway_[c.blockB].corners, c.edge);
        const Eigen::Matrix<double, 2, 6> ta = displacementMatrix(frames_[c.blockA], place);
        const Eigen::Matrix<double, 2, 6> tb = displacementMatrix(frames_[c.blockB], place);
        const auto link = [&](LinkKind kind, const Point& direction, double strain) -> Link& {
            Link& added = problem_.links.emplace_back();
            added.kind = kind;
            added.owner = index;
            added.features = (static_cast<std::uint64_t>(c.corner + 1) << 32) + static_cast<std::uint64_t>(c.edge);
            added.a = c.blockA;
            added.b = c.blockB;
            added.ga = ta.transpose() * direction;
            added.gb = -tb.transpose() * direction;
            added.strain = strain;
            return added;
        };
        const ContactSprings k = contactSprings(model_, c);
        const auto [open, free] = zeroPoints(c, k);
        const bool rigid = isAugmented(model_, c);
        const ContactStrains now = strainsOf(state_.blocks, c);
        Link& normal = link(LinkKind::Normal, edge.outward, now.gap);
        normal.law = {c.bonded ? LawKind::Linear : LawKind::Gap, k.normal, open, 0.0, nullptr, {}, 1.0, rigid};
        if (!problem_.openings.empty()) normal.shift = c.dilation - openingOf(problem_.openings, c);
        const bool locked = frictionLocked_ || c.bonded;
        const double limit = frictionLocked_ ? std::numeric_limits<double>::infinity() : c.limit;
        Link& friction = link(LinkKind::Friction, edge.along, now.slip);
        friction.law = {locked ? LawKind::Linear : LawKind::Capped, k.shear, free, limit, nullptr, {}, 1.0, rigid};
        const int at = static_cast<int>(problem_.links.size()) - 1;
        if (!locked) problem_.limitPairs.push_back({at, at - 1, frictionOf(model_, c)});
    }

private:
    const Model& model_;
    const State& state_;
    const std::vector<BlockMotion>& halfway_;
    std::vector<BlockFrame> frames_;  // of the blocks in the middle of the step
    bool frictionLocked_;
    StepProblem& problem_;
};

/// How far ahead contacts are set up [s]: to the middle of the step for schemes whose displacement follows from the
/// velocity at mid-step, so that two bodies in flight keep their angular momentum (theory, "Contacts").
double lookAhead(const StepOptions& options) {
    switch (options.inertia) {
        case Inertia::Shi:
        case Inertia::Newmark:
        case Inertia::GeneralizedAlpha: return 0.5 * options.dt;
        case Inertia::None:
        case Inertia::Static:
        case Inertia::BackwardEuler: return 0.0;
    }
    return 0.0;
}

void addLinks(const StepInput& input, StepProblem& problem) {
    addContactLinks(input.model, input.state, input.options.frictionLocked, problem, lookAhead(input.options),
                    input.options.path);
}

void accept(const Model&, State& state, const SolvedLink& solved) {
    const Link& link = solved.link;
    Contact& c = state.contacts[link.owner];
    if (link.kind == LinkKind::Normal) {
        c.normalForce = -solved.force;
        c.gapOffset -= link.shift;
        c.dilation -= link.shift;
        return;
    }
    c.shearForce = solved.force;
    if (link.law.kind == LawKind::Capped) c.limit = link.law.limit;
}

/// A contact that slid is locked at its present position under the force that it carries; one that stuck stays locked
/// where it was. \return the distance by which it slid [m].
double relockSlip(const Model& model, const State& state, const Link& link, double force, Contact& c) {
    c.slid = 0.0;
    const double slip = slipOf(state.blocks, c);
    if (!reachesLimit(link.law, force)) {
        // its corner moves on an arc, so it may be past a limit that its force never reached
        const double onArc = link.law.stiffness * (slip - link.law.offset);
        if (!link.law.rigid && std::abs(onArc) > link.law.limit) carryShear(model, c, slip, force);
        return 0.0;
    }
    const double before = link.law.rigid ? c.slipOffset : link.law.offset;
    carryShear(model, c, slip, force);
    c.slid = c.slipOffset - before;
    if (c.normalForce > 0.0) c.slip += c.slid;
    return c.slid;
}

void relock(const Model& model, State& state, const SolvedLink& solved) {
    const Link& link = solved.link;
    if (link.kind != LinkKind::Friction || link.law.kind != LawKind::Capped || link.law.stiffness <= 0.0) return;
    const double slid = relockSlip(model, state, link, solved.force, state.contacts[link.owner]);
    state.energy.friction += link.law.share * solved.slipForce * slid;
}

void finish(State& state) {
    for (Contact& c : state.contacts) {
        c.position = state.blocks[c.blockA].corners[c.corner];
        c.gap = gapOf(state.blocks, c);
        if (c.normalForce <= 0.0 && !c.bonded) c.normalMultiplier = 0.0;  // open: starts at zero when it closes again
    }
}

WallForce onBlock(const State& state, int block, const Point& at, const Point& force) {
    WallForce wall;
    wall.block = block;
    wall.place = materialPlace(state.blocks[block], at);
    wall.force = force;
    return wall;
}

/// True for forces at the level of coordinate round-off. Applied as external forces, they would push loose blocks for
/// ever.
bool isRoundOff(const Model& model, const Contact& c) {
    const BlockModel &a = model.blocks[c.blockA], &b = model.blocks[c.blockB];
    const double least = leastForce * std::min(a.youngsModulus, b.youngsModulus) * std::min(a.size, b.size);
    return std::hypot(c.normalForce, c.shearForce) <= least * model.thickness;
}

/// Forces of contacts between excavated and remaining rock. The force on A is N·outward − T·along; the force on B is
/// the opposite.
void addWallForces(const Model& model, const State& state, const std::vector<char>& excavated,
                   std::vector<WallForce>& walls) {
    for (const Contact& c : state.contacts) {
        if (excavated[c.blockA] == excavated[c.blockB] || isRoundOff(model, c)) continue;
        const Edge edge = edgeOf(state.blocks[c.blockB].corners, c.edge);
        const Point force = c.normalForce * edge.outward - c.shearForce * edge.along;
        const Point at = contactPoint(state.blocks, c);
        walls.push_back(excavated[c.blockB] ? onBlock(state, c.blockA, at, force)
                                            : onBlock(state, c.blockB, at, -force));
    }
}

void addStoredEnergy(const Model& model, const State& state, StoredEnergy& energy) {
    for (const Contact& c : state.contacts) energy.contact += contactEnergy(model, state.blocks, c);
}

}  // namespace

void addContactLinks(const Model& model, const State& state, bool frictionLocked, StepProblem& problem, double ahead,
                     const Eigen::VectorXd* path) {
    const bool on = ahead > 0.0 || path;
    const std::vector<BlockMotion> moved = on ? halfway(model, state, ahead, path) : std::vector<BlockMotion>{};
    ContactLinks links(model, state, on ? moved : state.blocks, frictionLocked, problem);
    for (std::size_t i = 0; i < state.contacts.size(); ++i) links.add(static_cast<int>(i));
}

const Carrier contactCarrier{.name = "contacts",
                             .addLinks = addLinks,
                             .ownsLink = ofContact,
                             .accept = accept,
                             .relock = relock,
                             .finish = finish,
                             .addLimits = addJointLimits,
                             .ownsLimit = ofJoint,
                             .changesForces = [](const Model&, const Limit&) { return true; },
                             .release = releaseJoint,
                             .addWallForces = addWallForces,
                             .addStoredEnergy = addStoredEnergy};

}  // namespace keyblock
