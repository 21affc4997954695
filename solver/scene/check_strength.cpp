// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A change of strength must find its joint material, change something, and not
// contradict another of its stage.
#include "solver/scene/check_report.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <algorithm>
#include <set>

namespace keyblock {

namespace {

void checkName(const StrengthChange& change, const std::string& pointer, const CheckContext& context) {
    std::vector<std::string_view> names;
    for (const auto& joint : context.scene.jointMaterials)
        names.push_back(joint.first);
    if (!change.jointMaterial.empty() && std::find(names.begin(), names.end(), change.jointMaterial) == names.end())
        context.report.error(under(pointer, "joint_material"),
                             inQuotes(change.jointMaterial) + " is not among the 'joint_materials'",
                             suggestion(change.jointMaterial, names));
}

}  // namespace

void checkStrengthChanges(const Stage& stage, const std::string& pointer, CheckContext& context) {
    std::set<std::string> changed;
    for (std::size_t i = 0; i < stage.set.size(); ++i) {
        const StrengthChange& change = stage.set[i];
        const std::string place = under(under(pointer, "set"), i);
        checkName(change, place, context);
        if (!change.frictionAngle && !change.cohesion && !change.tensileStrength)
            context.report.error(place, "this changes nothing",
                                 "Give 'friction_angle', 'cohesion' or 'tensile_strength'");
        if (!change.jointMaterial.empty() && !changed.insert(change.jointMaterial).second)
            context.report.error(under(place, "joint_material"),
                                 inQuotes(change.jointMaterial) + " is already changed in this stage",
                                 "Put all of its changes into one entry");
    }
}

}  // namespace keyblock
