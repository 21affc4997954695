// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/activation.h"

#include "solver/engine/bolt/plate.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/stage/carriers.h"
#include "solver/engine/stage/energy.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

/// Row of the bolt's plate if the plate is modelled as a block; −1 otherwise.
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

/// Frees bolt nodes and plates from excavated blocks, without a pull-out event.
void freeBolts(const Model& model, State& state) {
    for (std::size_t b = 0; b < state.bolts.size(); ++b) {
        BoltMotion& bolt = state.bolts[b];
        for (std::size_t s = 0; s < bolt.slots.size(); ++s)
            if (isGone(state, bolt.slots[s].block)) bolt.leftSlot[s] = 1;
        if (!bolt.plateHolds || !isGone(state, model.bolts[b].plate.block)) continue;
        losePlate(bolt);
    }
    followBolts(model, state);
}

/// The line of a bolt through the outer ends of its holes as they are now; the head stays at the rock face.
struct BoltLine {
    Point end{0.0, 0.0}, along{1.0, 0.0};  // a point of the bolt, and its direction
    double s = 0.0;  // distance of that point from the far end [m]

    Point at(double place) const { return end + (place - s) * along; }
};

BoltLine lineNow(const BoltModel& bolt, const State& state) {
    BoltLine line{bolt.farEnd, bolt.axis, 0.0};
    const auto remains = [&](const Slot& slot) { return !isGone(state, slot.block); };
    const auto first = std::find_if(bolt.slots.begin(), bolt.slots.end(), remains);
    const auto last = std::find_if(bolt.slots.rbegin(), bolt.slots.rend(), remains);
    if (first == bolt.slots.end()) return line;
    line.end = materialPoint(state.blocks[last->block], last->p3);
    line.along = (line.end - materialPoint(state.blocks[first->block], first->p2)).normalized();
    line.s = last->s3;
    return line;
}

/// Places a plate that is modelled as a block against its rock face, at the present position of the face.
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

}  // namespace

void leaveOut(const Model& model, State& state, int bolt) {
    state.bolts[bolt].absent = true;
    if (const int plate = plateRow(model, bolt); plate >= 0) takeOut(state, plate);
    dropContacts(state);
}

std::vector<WallForce> excavate(const Model& model, State& state, const std::vector<int>& rows) {
    std::vector<WallForce> walls;
    std::vector<char> excavated(model.blocks.size(), 0);
    for (int row : rows) excavated[row] = !state.blocks[row].absent;
    if (std::none_of(excavated.begin(), excavated.end(), [](char goes) { return goes != 0; })) return walls;
    const double before = accountedEnergy(model, state);
    for (const Carrier* carrier : carriers)
        if (carrier->addWallForces) carrier->addWallForces(model, state, excavated, walls);
    for (int row = 0; row < static_cast<int>(excavated.size()); ++row)
        if (excavated[row]) takeOut(state, row);
    dropContacts(state);
    freeBolts(model, state);
    state.energy.released += before - accountedEnergy(model, state);
    return walls;
}

void installBolt(const Model& model, State& state, int index) {
    const BoltModel& bolt = model.bolts[index];
    BoltMotion& motion = state.bolts[index];
    const StrengthFactors strength = motion.strength;
    motion = boltAtRest(bolt);
    motion.strength = strength;
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
    const double before = accountedEnergy(model, state);
    BoltMotion& motion = state.bolts[index];
    BoltMotion gone = boltAtRest(model.bolts[index]);
    gone.plasticEnergy = motion.plasticEnergy;
    gone.bondEnergy = motion.bondEnergy;
    gone.plateHolds = gone.tensioning = false;
    gone.absent = true;
    motion = std::move(gone);
    if (const int plate = plateRow(model, index); plate >= 0) takeOut(state, plate);
    dropContacts(state);
    state.energy.released += before - accountedEnergy(model, state);
}

std::vector<WallForce> releaseSupports(const Model& model, State& state, const std::vector<BoundarySide>& sides) {
    std::vector<WallForce> forces;
    const double before = accountedEnergy(model, state);
    for (std::size_t support : supportsOn(model, state, sides)) forces.push_back(releaseSupport(model, state, support));
    state.energy.released += before - accountedEnergy(model, state);
    return forces;
}

void restoreAllSupports(const Model& model, State& state) {
    if (state.supports.empty()) return;
    const double before = accountedEnergy(model, state);
    restoreSupports(model, state);
    state.energy.external += accountedEnergy(model, state) - before;  // the work on the springs comes from outside
}

}  // namespace keyblock
