// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/plate.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

void addPlateLinks(BoltStep& step) {
    if (!step.motion.plateHolds) return;
    const PlateModel& plate = step.bolt.plate;
    const BlockMotion& rock = step.state.blocks[plate.block];
    const int head = static_cast<int>(step.motion.nodes.size()) - 1;
    const Point place = materialPoint(rock, plate.place);
    const Point along = (materialPoint(rock, plate.place + plate.along) - place).normalized();
    const Point away = step.motion.nodes[head].x - place;
    Law& normal = step.toRock(LinkKind::PlateNormal, head, plate.block, along, along.dot(away), step.bolt.share).law;
    if (step.motion.tensioning) {
        normal.kind = LawKind::Constant;
        normal.limit = -step.bolt.pretension;
    } else {
        normal.stiffness = plate.normalStiffness;
        normal.offset = step.motion.plateOffset;
    }
    const Point across = turnLeft(along);
    Law& shear = step.toRock(LinkKind::PlateShear, head, plate.block, across, across.dot(away), step.bolt.share).law;
    shear.stiffness = plate.shearStiffness;
    shear.offset = step.motion.plateShearOffset;
}

bool ofPlate(LinkKind kind) { return kind == LinkKind::PlateNormal || kind == LinkKind::PlateShear; }

void acceptPlate(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved) {
    const Law& law = solved.link.law;
    if (solved.link.kind == LinkKind::PlateShear) {
        motion.plateShear = -solved.force;
        return;
    }
    if (law.kind == LawKind::Constant)  // work of the jack
        energy.external -= law.share * law.limit * (solved.strain - motion.plateStretch);
    motion.plateNormal = -solved.force;
    motion.plateStretch = solved.strain;
}

void addPlateLimit(const BoltModel& bolt, const BoltMotion& motion, int owner, std::vector<Limit>& limits) {
    if (!motion.plateHolds) return;
    const PlateModel& plate = bolt.plate;
    const double normal = plate.normalStrength ? std::abs(motion.plateNormal) / *plate.normalStrength : 0.0;
    const double shear = plate.shearStrength ? std::abs(motion.plateShear) / *plate.shearStrength : 0.0;
    const int head = static_cast<int>(motion.nodes.size()) - 1;
    limits.push_back({LimitKind::Plate, owner, head, std::max(normal, shear) / motion.strength.plate});
}

void losePlate(BoltMotion& motion) {
    motion.plateHolds = motion.tensioning = false;
    motion.plateNormal = motion.plateShear = 0.0;
}

void fitPlate(const BoltModel& bolt, const State& state, BoltMotion& motion) {
    if (!motion.plateHolds) return;
    if (state.blocks[bolt.plate.block].absent) {
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

void lockOffPlates(const Model& model, State& state) {
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        BoltMotion& motion = state.bolts[b];
        if (!motion.tensioning || !acts(motion)) continue;
        const BoltModel& bolt = model.bolts[b];
        const double force = bolt.pretension, stiffness = bolt.plate.normalStiffness;
        motion.tensioning = false;
        motion.plateOffset = motion.plateStretch + force / stiffness;
        state.energy.external += 0.5 * bolt.share * force * force / stiffness;  // work of the nut, stored in the plate
    }
}

}  // namespace keyblock
