// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks changes of strength: each must refer to a joint material, change
// something and not contradict another change in the same stage. Slip cannot
// increase friction.
#include "solver/scene/check_report.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"

#include <optional>
#include <set>

namespace keyblock {

namespace {

void checkName(const StrengthChange& change, const std::string& pointer, const CheckContext& context) {
    checkReference(change.jointMaterial, namesOf(context.scene.jointMaterials), "joint_materials",
                   under(pointer, "joint_material"), context.report);
}

/// Friction angle of a joint material after the changes up to and including `stage` [°]; none if the scene does not
/// contain the material.
std::optional<double> frictionAt(const Scene& scene, const std::string& name, const Stage& stage) {
    std::optional<double> angle;
    for (const auto& [joint, material] : scene.jointMaterials)
        if (joint == name) angle = material.frictionAngle;
    for (const Stage& before : scene.stages) {
        for (const StrengthChange& change : before.set)
            if (angle && change.jointMaterial == name) angle = change.frictionAngle.value_or(*angle);
        if (&before == &stage) break;
    }
    return angle;
}

void checkResidual(const StrengthChange& change, std::optional<double> peak, const std::string& pointer,
                   CheckReport& report) {
    if (!peak || !change.residualFrictionAngle || *change.residualFrictionAngle <= *peak) return;
    report.error(under(pointer, "residual_friction_angle"),
                 "friction cannot increase from " + shortest(*peak) + "° to " + shortest(*change.residualFrictionAngle) +
                     "° by slip",
                 "Give at most the friction angle, or change 'friction_angle' as well");
}

}  // namespace

void checkStrengthChanges(const Stage& stage, const std::string& pointer, CheckContext& context) {
    std::set<std::string> changed;
    for (std::size_t i = 0; i < stage.set.size(); ++i) {
        const StrengthChange& change = stage.set[i];
        const std::string place = under(under(pointer, "set"), i);
        checkName(change, place, context);
        if (!change.frictionAngle && !change.residualFrictionAngle && !change.cohesion && !change.tensileStrength)
            context.report.error(place, "this entry changes nothing",
                                 "Give 'friction_angle', 'residual_friction_angle', 'cohesion' or 'tensile_strength'");
        checkResidual(change, frictionAt(context.scene, change.jointMaterial, stage), place, context.report);
        if (!change.jointMaterial.empty() && !changed.insert(change.jointMaterial).second)
            context.report.error(under(place, "joint_material"),
                                 inQuotes(change.jointMaterial) + " is already changed in this stage",
                                 "Put all its changes into one entry");
    }
}

}  // namespace keyblock
