// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/activation.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/contacts.h"
#include "solver/engine/laws/step_law.h"
#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr double leastForce = 1e-12;  // of E · size · thickness: less is round-off

/// Row of the plate that is a block of its own; −1: none.
int plateRow(const Model& model, int bolt) {
    for (int row = model.firstOf.back(); row < static_cast<int>(model.blocks.size()); ++row)
        if (model.blocks[row].plateOf == bolt) return row;
    return -1;
}

bool isGone(const State& state, int block) { return block >= 0 && state.blocks[block].absent; }

void takeOut(State& state, int row) {
    BlockMotion& block = state.blocks[row];
    block.absent = true;
    block.velocity.setZero();
}

void dropContacts(State& state) {
    std::erase_if(state.contacts,
                  [&](const Contact& c) { return isGone(state, c.blockA) || isGone(state, c.blockB); });
}

WallForce onBlock(const State& state, int block, const Point& at, const Point& force) {
    WallForce wall;
    wall.block = block;
    wall.place = materialPlace(state.blocks[block], at);
    wall.force = force;
    return wall;
}

/// No more than digits of the places leave: held as a force from outside, it would push loose rock for ever.
bool isRoundOff(const Model& model, const Contact& c) {
    const BlockModel &a = model.blocks[c.blockA], &b = model.blocks[c.blockB];
    const double least = leastForce * std::min(a.youngsModulus, b.youngsModulus) * std::min(a.size, b.size);
    return std::hypot(c.normalForce, c.shearForce) <= least * model.thickness;
}

/// Of contacts between what goes and what stays: on A it is N·outward − T·along, on B the opposite.
void addContactForces(const Model& model, const State& state, const std::vector<char>& goes,
                      std::vector<WallForce>& walls) {
    for (const Contact& c : state.contacts) {
        if (goes[c.blockA] == goes[c.blockB] || isRoundOff(model, c)) continue;
        const Edge edge = edgeOf(state.blocks[c.blockB].corners, c.edge);
        const Point force = c.normalForce * edge.outward - c.shearForce * edge.along;
        const Point& at = state.blocks[c.blockA].corners[c.corner];
        walls.push_back(goes[c.blockB] ? onBlock(state, c.blockA, at, force) : onBlock(state, c.blockB, at, -force));
    }
}

/// Of anchored points and plates in what goes, on the nodes of their bolts.
void addBoltForces(const Model& model, const State& state, const std::vector<char>& goes,
                   std::vector<WallForce>& walls) {
    for (int b = 0; b < static_cast<int>(model.bolts.size()); ++b) {
        StepProblem links;
        links.blocks = static_cast<int>(model.blocks.size());
        links.nodes = model.nodes;
        addBoltLinks(model, state, b, links);
        for (const Link& link : links.links) {
            if (link.b < 0 || link.b >= links.blocks || !goes[link.b]) continue;
            WallForce wall;
            wall.bolt = b;
            wall.node = link.a - links.blocks - model.bolts[b].firstNode;
            wall.force = -link.law.share * carriedForce(link.law, link.strain) * link.ga.head<2>();
            if (!wall.force.isZero(0.0)) walls.push_back(wall);
        }
    }
}

/// Their nodes come free; nobody tells of them as pulled out.
void freeBolts(const Model& model, State& state) {
    for (std::size_t b = 0; b < state.bolts.size(); ++b) {
        BoltMotion& bolt = state.bolts[b];
        for (std::size_t s = 0; s < bolt.slots.size(); ++s)
            if (isGone(state, bolt.slots[s].block)) bolt.leftSlot[s] = 1;
        if (!bolt.plateHolds || !isGone(state, model.bolts[b].plate.block)) continue;
        bolt.plateHolds = bolt.tensioning = false;
        bolt.plateNormal = bolt.plateShear = 0.0;
    }
    followBolts(model, state);
}

/// Lies on the line through the outer ends of its holes where they are now, its head kept to the rock.
struct BoltLine {
    Point end{0.0, 0.0}, along{1.0, 0.0};  // a place of the bolt, and its direction
    double s = 0.0;  // of that place from the far end [m]

    Point at(double place) const { return end + (place - s) * along; }
};

BoltLine lineNow(const BoltModel& bolt, const State& state) {
    BoltLine line{bolt.farEnd, bolt.axis, 0.0};
    const auto stands = [&](const Slot& slot) { return !isGone(state, slot.block); };
    const auto first = std::find_if(bolt.slots.begin(), bolt.slots.end(), stands);
    const auto last = std::find_if(bolt.slots.rbegin(), bolt.slots.rend(), stands);
    if (first == bolt.slots.end()) return line;
    line.end = materialPoint(state.blocks[last->block], last->p3);
    line.along = (line.end - materialPoint(state.blocks[first->block], first->p2)).normalized();
    line.s = last->s3;
    return line;
}

/// The plate that is a block goes with the face that it lies against.
void placePlate(const Model& model, State& state, int row) {
    const BlockModel& plate = model.blocks[row];
    const int rock = rowHolding(model, plate.rock, plate.centroid);
    const BlockMotion& face = state.blocks[rock];
    BlockMotion motion;
    motion.centroid = materialPoint(face, plate.centroid - model.blocks[rock].centroid);
    motion.angle = face.angle;
    placeCorners(plate, motion);
    state.blocks[row] = std::move(motion);
}

/// The plate's springs carry nothing where the head is.
void fitPlate(const BoltModel& bolt, const State& state, BoltMotion& motion) {
    if (!motion.plateHolds) return;
    if (isGone(state, bolt.plate.block)) {
        motion.plateHolds = motion.tensioning = false;
        return;
    }
    const BlockMotion& rock = state.blocks[bolt.plate.block];
    const Point place = materialPoint(rock, bolt.plate.place);
    const Point along = (materialPoint(rock, bolt.plate.place + bolt.plate.along) - place).normalized();
    const Point away = motion.nodes.back().x - place;
    motion.plateOffset = motion.plateStretch = along.dot(away);
    motion.plateShearOffset = turnLeft(along).dot(away);
}

}  // namespace

void leaveOut(const Model& model, State& state, int bolt) {
    state.bolts[bolt].absent = true;
    if (const int plate = plateRow(model, bolt); plate >= 0) takeOut(state, plate);
    dropContacts(state);
}

std::vector<WallForce> excavate(const Model& model, State& state, const std::vector<int>& rows) {
    std::vector<WallForce> walls;
    std::vector<char> goes(model.blocks.size(), 0);
    for (int row : rows) goes[row] = !state.blocks[row].absent;
    if (std::none_of(goes.begin(), goes.end(), [](char g) { return g != 0; })) return walls;
    const double before = bookedEnergy(model, state);
    addContactForces(model, state, goes, walls);
    addBoltForces(model, state, goes, walls);
    for (int row = 0; row < static_cast<int>(goes.size()); ++row)
        if (goes[row]) takeOut(state, row);
    dropContacts(state);
    freeBolts(model, state);
    state.energy.released += before - bookedEnergy(model, state);
    return walls;
}

void installBolt(const Model& model, State& state, int index) {
    const BoltModel& bolt = model.bolts[index];
    BoltMotion& motion = state.bolts[index];
    const double factor = motion.strengthFactor;
    motion = boltAtRest(bolt);
    motion.strengthFactor = factor;
    if (const int plate = plateRow(model, index); plate >= 0) placePlate(model, state, plate);
    const BoltLine line = lineNow(bolt, state);
    const double turn = std::atan2(cross(bolt.axis, line.along), bolt.axis.dot(line.along));
    for (std::size_t n = 0; n < motion.nodes.size(); ++n) {
        motion.nodes[n].x = line.at(bolt.s[n]);
        motion.nodes[n].angle = turn;
    }
    for (Slot& slot : motion.slots) {
        slot.p2 = materialPlace(state.blocks[slot.block], line.at(slot.s2));
        slot.p3 = materialPlace(state.blocks[slot.block], line.at(slot.s3));
    }
    fitPlate(bolt, state, motion);
    placeBoltNow(model, state, index);
}

void removeBolt(const Model& model, State& state, int index) {
    const double before = bookedEnergy(model, state);
    BoltMotion& motion = state.bolts[index];
    BoltMotion gone = boltAtRest(model.bolts[index]);
    gone.plasticEnergy = motion.plasticEnergy;
    gone.bondEnergy = motion.bondEnergy;
    gone.plateHolds = gone.tensioning = false;
    gone.absent = true;
    motion = std::move(gone);
    if (const int plate = plateRow(model, index); plate >= 0) takeOut(state, plate);
    dropContacts(state);
    state.energy.released += before - bookedEnergy(model, state);
}

}  // namespace keyblock
