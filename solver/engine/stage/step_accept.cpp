// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// After a step was solved: forces and history into the state, bodies to their
// new places, and the books of the energies.
#include "solver/engine/stage/step_build.h"

#include "solver/engine/contact/contacts.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr double stuckShare = 1e-12;  // of the limit: friction under it has not slid
constexpr double slidingShare = 1e-6;  // of its limit: an anchored point under less than the rest sticks

void acceptContact(const Link& link, double force, Contact& c) {
    if (link.kind == LinkKind::Normal) {
        c.normalForce = -force;
        c.gapOffset -= link.shift;
        c.dilation -= link.shift;
        return;
    }
    c.shearForce = force;
    if (link.law.kind == LawKind::Capped) c.limit = link.law.limit;
}

/// At the limit of friction, or on the curve itself and not on a branch of unloading.
bool slides(const Law& law, const BackboneState& curve, double force) {
    if (law.kind != LawKind::Capped && law.kind != LawKind::Curve) return false;
    const double limit = law.kind == LawKind::Curve ? yieldForce(*law.curve, curve.accumulated) : law.limit;
    return std::abs(force) >= (1.0 - slidingShare) * limit;
}

void acceptBoltLink(const Link& link, double strain, double force, const BackboneState& curve, const BoltModel& bolt,
                    BoltMotion& motion) {
    switch (link.kind) {
        case LinkKind::Axial: {
            BoltElementState& e = motion.elements[link.part];
            e.strain = strain;
            e.axialForce = bolt.section.area * force;
            if (link.law.kind == LawKind::Curve) e.steel = curve;
            return;
        }
        case LinkKind::Bend: {
            BoltElementState& e = motion.elements[link.part];
            e.moment1 = force;
            e.bend = strain - link.law.offset;
            e.bendLimit = link.law.limit;
            return;
        }
        case LinkKind::Shear: {  // follows its bending partner
            BoltElementState& e = motion.elements[link.part];
            const BeamForces forces = beamForces(e.moment1, force, bolt.elements[link.part].length);
            e.moment1 = forces.moment1;
            e.moment2 = forces.moment2;
            e.shearForce = forces.shear;
            return;
        }
        case LinkKind::AnchorSlip: {
            NodeBond& bond = motion.nodes[link.part].bond;
            bond.force = -force * bond.share;
            bond.slip = -strain;
            if (link.law.kind == LawKind::Curve) bond.curve = curve;
            bond.sliding = !bond.bonded && slides(link.law, curve, force);
            return;
        }
        case LinkKind::AnchorNormal: {
            BoltNode& node = motion.nodes[link.part];
            node.normalForce = force * node.normalShare;
            return;
        }
        case LinkKind::PlateNormal:
            motion.plateNormal = -force;
            motion.plateStretch = strain;
            return;
        case LinkKind::PlateShear: motion.plateShear = -force; return;
        default: return;
    }
}

/// A contact that slid is locked where it is now, under the force it carries; one that stuck stays locked where it was.
/// \return how far it slid [m].
double relockContact(const Model& model, const State& state, const Link& link, double force, Contact& c) {
    c.slid = 0.0;
    const double slip = slipOf(state.blocks, c);
    if (std::abs(force) < link.law.limit * (1.0 - stuckShare)) {
        // on the arc that its corner went it may be past a limit that it never reached
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

/// Force of a capped link while it slid: its mean on the way, where the books know it.
double slipForceOf(const StepProblem& problem, const std::vector<double>& forces, std::size_t link) {
    return problem.slipForce.empty() ? forces[link] : problem.slipForce[link];
}

/// Moves the zero points of hinges that turned and of rock that was crushed: what they did not take is elastic.
void yieldAcross(const Model& model, State& state, const StepProblem& problem, const std::vector<double>& forces) {
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        const bool bend = link.kind == LinkKind::Bend, sway = link.kind == LinkKind::Shear;
        if (link.law.kind != LawKind::Capped || !(bend || sway || link.kind == LinkKind::AnchorNormal)) continue;
        if (std::abs(forces[i]) < link.law.limit) continue;
        BoltMotion& motion = state.bolts[link.owner];
        const double elastic = forces[i] / link.law.stiffness;
        double& offset = bend ? motion.elements[link.part].hingeBend
                       : sway ? motion.elements[link.part].hingeSway : motion.nodes[link.part].normalOffset;
        if (bend || sway) {
            const BeamStrains strains = strainsOf(model.bolts[link.owner], motion, link.part);
            offset = (bend ? strains.p1 : strains.p2) - elastic;
        } else {
            const BoltNode& node = motion.nodes[link.part];
            offset = offSlot(slotLine(state, motion.slots[node.slot]), node) - elastic;
        }
        const double work = link.law.share * slipForceOf(problem, forces, i) * (offset - link.law.offset);
        state.energy.plastic += work;
        motion.plasticEnergy += work;
    }
}

/// An anchored point that slid is locked anew, as a contact is; one that stuck stays locked where it was.
/// \return how far its zero point went along the slot [m].
double relockAnchor(const State& state, const Link& link, double force, BoltMotion& motion) {
    if (std::abs(force) < link.law.limit * (1.0 - stuckShare)) return 0.0;
    BoltNode& node = motion.nodes[link.part];
    node.bond.offset = alongSlot(slotLine(state, motion.slots[node.slot]), node) - force / link.law.stiffness;
    return node.bond.offset - link.law.offset;
}

/// Moves the offset of every sliding law so that it carries the accepted force where the bodies are now.
void relock(const Model& model, State& state, const StepProblem& problem, const std::vector<double>& forces) {
    for (std::size_t i = 0; i < problem.links.size(); ++i) {
        const Link& link = problem.links[i];
        if (link.law.kind != LawKind::Capped || link.law.stiffness <= 0.0) continue;
        double slid = 0.0;
        if (link.kind == LinkKind::Friction)
            slid = relockContact(model, state, link, forces[i], state.contacts[link.owner]);
        else if (link.kind == LinkKind::AnchorSlip)
            slid = relockAnchor(state, link, forces[i], state.bolts[link.owner]);
        else
            continue;
        const double work = link.law.share * slipForceOf(problem, forces, i) * slid;
        state.energy.friction += work;
        if (link.kind == LinkKind::AnchorSlip) state.bolts[link.owner].bondEnergy += work;
    }
    for (Contact& c : state.contacts) {
        c.position = state.blocks[c.blockA].corners[c.corner];
        c.gap = gapOf(state.blocks, c);
        if (c.normalForce <= 0.0 && !c.bonded) c.normalMultiplier = 0.0;  // open: it starts anew when it closes
    }
}

/// Plastic work of the steel, or of an anchor along its curve.
void bookCurve(const Link& link, double work, State& state) {
    BoltMotion& motion = state.bolts[link.owner];
    const bool steel = link.kind == LinkKind::Axial;
    (steel ? state.energy.plastic : state.energy.friction) += link.law.share * work;
    (steel ? motion.plasticEnergy : motion.bondEnergy) += link.law.share * work;
}

/// A force that stays whatever moves: friction of an anchored point, or the jack that pulls the head to its pretension.
void bookConstant(const Link& link, double strain, State& state) {
    BoltMotion& motion = state.bolts[link.owner];
    const bool jack = link.kind == LinkKind::PlateNormal;
    const double before = jack ? motion.plateStretch : -motion.nodes[link.part].bond.slip;
    const double work = link.law.share * link.law.limit * (strain - before);
    if (jack) {
        state.energy.external -= work;
        return;
    }
    state.energy.friction += work;
    motion.bondEnergy += work;
}

/// The block that carries each node round: its own, or that of the next node along the whole bar; −1: none.
std::vector<int> carriersOf(const BoltMotion& bolt) {
    std::vector<int> carriers;
    for (const BoltNode& node : bolt.nodes) carriers.push_back(node.slot < 0 ? -1 : bolt.slots[node.slot].block);
    const auto pass = [&](std::size_t from, std::size_t to, std::size_t element) {
        if (carriers[to] < 0 && !bolt.elements[element].ruptured) carriers[to] = carriers[from];
    };
    for (std::size_t e = 0; e < bolt.elements.size(); ++e) pass(e, e + 1, e);
    for (std::size_t e = bolt.elements.size(); e-- > 0;) pass(e + 1, e, e);
    return carriers;
}

/// A step is solved with linear displacements and blocks turn by the exact rotation: so must the nodes that they carry,
/// or a bolt in a spinning block is drawn out at every step. \return what `x` moves beyond its linear displacement.
Point roundTheBend(const BlockMotion& block, double turn, const Point& x) {
    const Point arm = x - block.centroid;
    return (std::cos(turn) - 1.0) * arm + (std::sin(turn) - turn) * turnLeft(arm);
}

void moveNodes(State& state, BoltMotion& bolt, const Eigen::VectorXd& d, Eigen::Index at) {
    const std::vector<int> carriers = acts(bolt) ? carriersOf(bolt) : std::vector<int>(bolt.nodes.size(), -1);
    for (std::size_t n = 0; n < bolt.nodes.size(); ++n, at += 3) {
        BoltNode& node = bolt.nodes[n];
        const int block = carriers[n];
        if (block >= 0) node.x += roundTheBend(state.blocks[block], d[6 * block + 2], node.x);
        node.x += d.segment<2>(at);
        node.angle += d[at + 2];
    }
}

}  // namespace

void moveBodies(const Model& model, State& state, const Eigen::VectorXd& d) {
    Eigen::Index at = 6 * static_cast<Eigen::Index>(model.blocks.size());
    for (BoltMotion& bolt : state.bolts) {
        moveNodes(state, bolt, d, at);
        at += 3 * static_cast<Eigen::Index>(bolt.nodes.size());
    }
    for (std::size_t i = 0; i < model.blocks.size(); ++i)
        if (!model.blocks[i].fixed)
            moveBlock(model.blocks[i], state.blocks[i], d.segment<6>(6 * static_cast<Eigen::Index>(i)));
}

void acceptStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    std::vector<double> forces(strains.size());
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        BackboneState curve;
        if (link.law.kind == LawKind::Curve) {
            const BackboneResponse r = respond(*link.law.curve, link.law.state, strains[i]);
            forces[i] = r.force;
            curve = r.state;
            bookCurve(link, r.plasticWork, state);
        } else {
            forces[i] = respond(link.law, strains[i]).force;
        }
        if (link.law.kind == LawKind::Constant) bookConstant(link, strains[i], state);
        if (ofContact(link.kind))
            acceptContact(link, forces[i], state.contacts[link.owner]);
        else if (link.kind != LinkKind::Support && link.kind != LinkKind::Glue && link.kind != LinkKind::Drag)
            acceptBoltLink(link, strains[i], forces[i], curve, model.bolts[link.owner], state.bolts[link.owner]);
    }
    if (!problem.openings.empty()) state.openings = problem.openings;
    moveBodies(model, state, d);
    relock(model, state, problem, forces);
    yieldAcross(model, state, problem, forces);
}

}  // namespace keyblock
