// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/automatic.h"

#include "solver/scene/acceleration.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/preset.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double equilibrium = 1e-4;  // ratio of the unbalanced force to the reference force
constexpr double longestTimeStep = 1e-3;  // [s]
constexpr double fewestSteps = 200.0;  // in a dynamic stage
constexpr double modulusOfSteel = 200e9;  // [Pa]

/// Square of the inner diameter of a tube [m²]; 0 for a solid bar.
double innerSquared(const BoltType& type) {
    const double d = type.diameter;
    return std::max(0.0, d * d - 4.0 * boltSteel(type).area / std::numbers::pi);
}

}  // namespace

double automaticUnbalanced(const Scene& scene) { return std::min(equilibrium, numericsOf(scene.analysis).tolerance); }

double automaticTimeStep(const Scene& scene, const Stage& stage) {
    const double factor = numericsOf(scene.analysis).timeStepFactor;
    const double longest = factor * std::min(longestTimeStep, stage.duration / fewestSteps);
    return std::min(longest, std::min(1.0, factor) * longestStepFor(stage));
}

double automaticSecondMoment(const BoltType& type) {
    const double d = type.diameter, inner2 = innerSquared(type);
    return std::numbers::pi / 64.0 * (d * d * d * d - inner2 * inner2);
}

double automaticPlasticModulus(const BoltType& type) {
    const double d = type.diameter, inner = std::sqrt(innerSquared(type));
    return (d * d * d - inner * inner * inner) / 6.0;
}

double automaticYoungsModulus(const BoltType& type) {
    const auto isStrained = [](const auto& row) { return row.first > 0.0; };
    const auto end = std::find_if(type.steel.begin(), type.steel.end(), isStrained);
    return end == type.steel.end() ? modulusOfSteel : end->second / end->first;
}

std::string automaticJointMaterial(const Scene& scene) {
    return scene.jointMaterials.empty() ? std::string() : scene.jointMaterials.front().first;
}

std::string automaticTraceMaterial(const Scene& scene) {
    const bool ofDomain = scene.domain && scene.domain->jointMaterial;
    return ofDomain ? *scene.domain->jointMaterial : automaticJointMaterial(scene);
}

}  // namespace keyblock
