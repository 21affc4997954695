// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt.h"

#include "solver/engine/bolt/anchor.h"
#include "solver/engine/bolt/plate.h"
#include "solver/engine/bolt/shank.h"
#include "solver/engine/time/mass.h"

#include <cmath>

namespace keyblock {
namespace {

void addLinks(const StepInput& input, StepProblem& problem) {
    for (std::size_t b = 0; b < input.model.bolts.size(); ++b)
        addBoltLinks(input.model, input.state, static_cast<int>(b), problem);
}

bool ofBolt(LinkKind kind) { return ofShank(kind) || ofAnchor(kind) || ofPlate(kind); }

void accept(const Model& model, State& state, const SolvedLink& solved) {
    const LinkKind kind = solved.link.kind;
    BoltMotion& motion = state.bolts[solved.link.owner];
    if (ofShank(kind)) acceptShank(model.bolts[solved.link.owner], motion, state.energy, solved);
    else if (ofAnchor(kind)) acceptAnchor(motion, state.energy, solved);
    else acceptPlate(motion, state.energy, solved);
}

void relock(const Model& model, State& state, const SolvedLink& solved) {
    const LinkKind kind = solved.link.kind;
    BoltMotion& motion = state.bolts[solved.link.owner];
    if (ofShank(kind)) relockShank(model.bolts[solved.link.owner], motion, state.energy, solved);
    else if (ofAnchor(kind)) relockAnchor(state, motion, state.energy, solved);
}

/// Adds the limits node by node, each followed by the element that starts there, then the limit of the plate.
void addLimitsOf(const BoltModel& bolt, const BoltMotion& motion, int owner, std::vector<Limit>& limits) {
    for (int i = 0; i < static_cast<int>(motion.nodes.size()); ++i) {
        addAnchorLimits(bolt, motion, owner, i, limits);
        if (i < static_cast<int>(motion.elements.size())) addShankLimits(bolt, motion, owner, i, limits);
    }
    addPlateLimit(bolt, motion, owner, limits);
}

void addLimits(const Model& model, const State& state, std::vector<Limit>& limits) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b)
        if (acts(state.bolts[b])) addLimitsOf(model.bolts[b], state.bolts[b], static_cast<int>(b), limits);
}

bool ownsLimit(LimitKind kind) { return ofShank(kind) || ofAnchor(kind) || kind == LimitKind::Plate; }

bool changesForces(const Model& model, const Limit& limit) {
    if (ofAnchor(limit.kind)) return anchorChangesForces(model.bolts[limit.owner].anchors[limit.part], limit);
    return limit.kind != LimitKind::Yield && limit.kind != LimitKind::Hinge;
}

/// The axial force, with its sign, of that element next to the node whose |N| is larger.
double axialBeside(const BoltMotion& motion, int node) {
    double axial = 0.0;
    for (int e : {node - 1, node}) {
        if (e < 0 || e >= static_cast<int>(motion.elements.size()) || motion.elements[e].ruptured) continue;
        if (std::abs(motion.elements[e].axialForce) > std::abs(axial)) axial = motion.elements[e].axialForce;
    }
    return axial;
}

EventKind eventOf(const BoltModel& bolt, const BoltMotion& motion, const Limit& limit) {
    if (ofShank(limit.kind)) return shankEvent(bolt, motion, limit);
    return limit.kind == LimitKind::Plate ? EventKind::PlateLoss : EventKind::Debonding;
}

void releasePart(const BoltModel& bolt, const Limit& limit, BoltMotion& motion) {
    if (ofShank(limit.kind)) releaseShank(motion, limit);
    else if (ofAnchor(limit.kind)) releaseAnchor(bolt.anchors[limit.part], limit, motion);
    else losePlate(motion);
}

void loseBolt(BoltMotion& motion) {
    motion.lost = true;
    motion.plateHolds = false;
    motion.plateNormal = motion.plateShear = 0.0;
    for (BoltNode& node : motion.nodes) {
        node.velocity.setZero();
        loseAnchor(node);
    }
    for (BoltElementState& element : motion.elements) unloadElement(element);
}

std::vector<Event> release(const Model& model, State& state, const Limit& limit) {
    const BoltModel& bolt = model.bolts[limit.owner];
    BoltMotion& motion = state.bolts[limit.owner];
    std::vector<Event> events{boltEvent(model, state, limit, eventOf(bolt, motion, limit))};
    const double held = boltEnergy(model, state, limit.owner);
    releasePart(bolt, limit, motion);
    const bool anchorFails = ofAnchor(limit.kind);
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

/// Forces of anchored points and plates in excavated blocks on the nodes of their bolts.
void addWallForces(const Model& model, const State& state, const std::vector<char>& excavated,
                   std::vector<WallForce>& walls) {
    for (int b = 0; b < static_cast<int>(model.bolts.size()); ++b) {
        StepProblem links = stepForLinks(model);
        addBoltLinks(model, state, b, links);
        for (const Link& link : links.links) {
            if (link.b < 0 || link.b >= links.blocks || !excavated[link.b]) continue;
            WallForce wall;
            wall.bolt = b;
            wall.node = link.a - links.blocks - model.bolts[b].firstNode;
            wall.force = -link.law.share * carriedForce(link.law, link.strain) * link.ga.head<2>();
            if (!wall.force.isZero(0.0)) walls.push_back(wall);
        }
    }
}

void addStoredEnergy(const Model& model, const State& state, StoredEnergy& energy) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b) energy.bolt += boltEnergy(model, state, static_cast<int>(b));
}

}  // namespace

void addBoltLinks(const Model& model, const State& state, int index, StepProblem& problem,
                  RockGradients rockGradients) {
    const BoltMotion& motion = state.bolts[index];
    if (!acts(motion)) return;
    BoltStep step(model, state, index, problem, rockGradients);
    for (int e = 0; e < static_cast<int>(motion.elements.size()); ++e)
        if (!motion.elements[e].ruptured) addShankLinks(step, e);
    for (int n = 0; n < static_cast<int>(motion.nodes.size()); ++n)
        if (motion.nodes[n].slot >= 0) addAnchorLinks(step, n);
    addPlateLinks(step);
}

double boltEnergy(const Model& model, const State& state, int bolt) {
    StepProblem links = stepForLinks(model);
    links.links.reserve(linksANode * state.bolts[bolt].nodes.size());
    addBoltLinks(model, state, bolt, links, RockGradients::LeftOut);
    return addLinkEnergy(links, 0.0);
}

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

const Carrier boltCarrier{.name = "bolts",
                          .addLinks = addLinks,
                          .ownsLink = ofBolt,
                          .accept = accept,
                          .relock = relock,
                          .addLimits = addLimits,
                          .ownsLimit = ownsLimit,
                          .changesForces = changesForces,
                          .release = release,
                          .addWallForces = addWallForces,
                          .addStoredEnergy = addStoredEnergy};

}  // namespace keyblock
