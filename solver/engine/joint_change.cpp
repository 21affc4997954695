// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/joint_change.h"

#include "solver/engine/contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

void change(JointMaterial& material, const StrengthChange& to) {
    material.frictionAngle = to.frictionAngle.value_or(material.frictionAngle);
    material.cohesion = to.cohesion.value_or(material.cohesion);
    material.tensileStrength = to.tensileStrength.value_or(material.tensileStrength);
}

bool bonds(const JointModel& joint) { return joint.cohesion > 0.0 || joint.tensileStrength > 0.0; }

/// Friction alone bears what the contact carries.
bool frictionBears(const JointModel& joint, const Contact& c) {
    return c.normalForce >= 0.0 && std::abs(c.shearForce) <= c.normalForce * joint.tanPhi;
}

bool touches(const Model& model, const Contact& c) { return c.gap - c.gapOffset <= 10.0 * model.tolerance; }

}  // namespace

std::vector<JointModel> jointModels(const Scene& scene, int stage) {
    auto materials = scene.jointMaterials;
    for (int i = 0; i <= stage; ++i)
        for (const StrengthChange& to : scene.stages[static_cast<std::size_t>(i)].set)
            for (auto& [name, material] : materials)
                if (name == to.jointMaterial) change(material, to);
    std::vector<JointModel> models;
    for (const auto& [name, material] : materials) models.push_back(jointModel(material));
    models.push_back(jointModel(builtInJointMaterial));
    return models;
}

void changeJoints(Model& model, State& state, std::vector<JointModel> joints) {
    const std::vector<JointModel> before = std::exchange(model.joints, std::move(joints));
    for (Contact& c : state.contacts) {
        const bool couldBond = bonds(before[c.joint]);
        c.joint = governingJoint(model, c.blockA, c.blockB);
        const JointModel& joint = model.joints[c.joint];
        if (!couldBond && bonds(joint) && c.length > 0.0 && touches(model, c)) c.bonded = true;
        if (c.bonded && !bonds(joint) && frictionBears(joint, c)) c.bonded = false;
        if (!c.bonded) c.limit = std::max(0.0, c.normalForce) * joint.tanPhi;
    }
}

}  // namespace keyblock
