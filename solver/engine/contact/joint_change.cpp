// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/joint_change.h"

#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/contact_history.h"
#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/springs.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

void change(JointMaterial& material, const StrengthChange& to) {
    material.frictionAngle = to.frictionAngle.value_or(material.frictionAngle);
    if (to.residualFrictionAngle) material.residualFrictionAngle = to.residualFrictionAngle;
    material.cohesion = to.cohesion.value_or(material.cohesion);
    material.tensileStrength = to.tensileStrength.value_or(material.tensileStrength);
}

bool bonds(const JointModel& joint) { return joint.cohesion > 0.0 || joint.tensileStrength > 0.0; }

/// True if friction alone can carry the forces of the contact.
bool frictionBears(const JointModel& joint, const Contact& c) {
    const double friction = c.slipped ? joint.tanResidual : joint.tanPhi;
    return c.normalForce >= 0.0 && std::abs(c.shearForce) <= c.normalForce * friction;
}

bool touches(const Model& model, const Contact& c) { return c.gap - c.gapOffset <= 10.0 * model.tolerance; }

/// Bonds a contact with grout over the length on which its faces meet now, wherever they met when the contact was
/// found. Plates are not bonded.
void bond(const Model& model, const State& state, Contact& c) {
    const bool plate = model.blocks[c.blockA].plateOf >= 0 || model.blocks[c.blockB].plateOf >= 0;
    const double length = lengthOfJoint(model, state.blocks, c);
    if (plate || length <= 0.0 || !touches(model, c)) return;
    const JointModel& joint = model.joints[c.joint];
    if (!joint.normalStiffness && !joint.shearStiffness) c.length = length;  // otherwise the length is already set
    c.bonded = true;
}

/// Marks the rows of Model::joints that had cohesion or tensile strength at any time before `stage`.
std::vector<char> everBonded(const Scene& scene, int stage) {
    std::vector<char> ever(jointRows(scene.jointMaterials).size(), 0);
    for (int before = -1; before < stage; ++before) {
        const std::vector<JointModel> joints = jointModels(scene, before);
        for (std::size_t i = 0; i < joints.size(); ++i) ever[i] = ever[i] || bonds(joints[i]);
    }
    return ever;
}

}  // namespace

std::vector<JointModel> jointModels(const Scene& scene, int stage) {
    auto materials = scene.jointMaterials;
    for (int i = 0; i <= stage; ++i)
        for (const StrengthChange& to : scene.stages[i].set)
            for (auto& [name, material] : materials)
                if (name == to.jointMaterial) change(material, to);
    return jointRows(materials);
}

void changeJoints(const Scene& scene, int stage, Model& model, State& state) {
    const std::vector<char> bonded = everBonded(scene, stage);
    model.joints = jointModels(scene, stage);
    for (Contact& c : state.contacts) {
        const bool neverBonded = !bonded[c.joint];
        if (c.joint == intactRow(model)) continue;
        c.joint = governingJoint(model, state.blocks, c, false);
        const JointModel& joint = model.joints[c.joint];
        if (neverBonded && bonds(joint)) bond(model, state, c);
        if (c.bonded && !bonds(joint)) {
            state.energy.released += partBondedFace(model, state.blocks, state.contacts, c);
            if (frictionBears(joint, c)) c.bonded = false;
        }
        if (!c.bonded) c.limit = std::max(0.0, c.normalForce) * frictionOf(model, c);
    }
    state.energy.released += joinBondedFaces(model, state.blocks, state.contacts);
}

}  // namespace keyblock
