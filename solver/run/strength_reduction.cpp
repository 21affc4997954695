// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Only the document is changed: what runs is an ordinary scene, so that every law,
// lagged limit and event is the same as in `run`.
#include "solver/run/strength_reduction.h"

#include "solver/scene/pointer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Angle [°] whose tangent is that of `angle` over `factor`. A factor of 1 keeps the angle as it is, because conversion
/// to a tangent and back could change its last digits.
double reducedAngle(double angle, double factor) {
    return factor == 1.0 ? angle : std::atan(std::tan(angle * degree) / factor) / degree;
}

void reduceAngle(std::optional<double>& angle, double factor) {
    if (angle) *angle = reducedAngle(*angle, factor);
}

void divide(std::optional<double>& strength, double factor) {
    if (strength) *strength /= factor;
}

void reduceJoints(Scene& scene, double factor) {
    if (scene.jointMaterials.empty()) scene.jointMaterials.emplace_back("joint", builtInJointMaterial);
    for (auto& [name, joint] : scene.jointMaterials) {
        joint.frictionAngle = reducedAngle(joint.frictionAngle, factor);
        reduceAngle(joint.residualFrictionAngle, factor);
        joint.cohesion /= factor;
        joint.tensileStrength /= factor;
    }
    for (Stage& stage : scene.stages)
        for (StrengthChange& change : stage.set) {
            reduceAngle(change.frictionAngle, factor);
            reduceAngle(change.residualFrictionAngle, factor);
            divide(change.cohesion, factor);
            divide(change.tensileStrength, factor);
        }
}

/// A curve is scaled towards its origin, so that its slopes stay the same, like the stiffness of the other laws. The
/// same applies to a softening bond.
void reduceAnchors(std::vector<Anchor>& anchors, double factor) {
    for (Anchor& anchor : anchors) {
        divide(anchor.strength, factor);
        anchor.residual /= factor;
        anchor.softeningSlip /= factor;
        anchor.frictionAngle = reducedAngle(anchor.frictionAngle, factor);
        for (auto& [slip, force] : anchor.curve) {
            slip /= factor;
            force /= factor;
        }
    }
}

void reduceBonds(Scene& scene, double factor) {
    for (BoltType& type : scene.boltTypes) reduceAnchors(type.anchors, factor);
    for (Bolt& bolt : scene.bolts)
        if (bolt.anchors) reduceAnchors(*bolt.anchors, factor);
}

bool reducesJoints(const Scene& scene) { return scene.safety.reduce != Reduce::Bonds; }
bool reducesBonds(const Scene& scene) { return scene.safety.reduce != Reduce::Joints; }

bool hasStrength(const JointMaterial& joint) {
    return joint.frictionAngle > 0.0 || joint.cohesion > 0.0 || joint.tensileStrength > 0.0;
}

bool hasStrength(const StrengthChange& change) {
    return change.frictionAngle.value_or(0.0) > 0.0 || change.cohesion.value_or(0.0) > 0.0 ||
           change.tensileStrength.value_or(0.0) > 0.0;
}

bool someJointHasStrength(const Scene& scene) {
    const auto joint = [](const auto& named) { return hasStrength(named.second); };
    const auto change = [](const StrengthChange& one) { return hasStrength(one); };
    const auto stage = [&](const Stage& one) { return std::ranges::any_of(one.set, change); };
    return scene.jointMaterials.empty() || std::ranges::any_of(scene.jointMaterials, joint) ||
           std::ranges::any_of(scene.stages, stage);
}

bool someBondHasStrength(const Scene& scene) {
    const auto limited = [](const Anchor& anchor) {
        return anchor.strength || !anchor.curve.empty() || anchor.frictionAngle > 0.0;
    };
    const auto ofType = [&](const std::string& name) {
        const auto type = std::ranges::find(scene.boltTypes, name, &BoltType::name);
        return type != scene.boltTypes.end() && std::ranges::any_of(type->anchors, limited);
    };
    const auto ofBolt = [&](const Bolt& bolt) {
        return bolt.anchors ? std::ranges::any_of(*bolt.anchors, limited) : ofType(bolt.type);
    };
    return std::ranges::any_of(scene.bolts, ofBolt) ||
           std::ranges::any_of(scene.boltPatterns, [&](const ScenePattern& pattern) { return ofType(pattern.type); });
}

Problem error(std::string pointer, std::string message, std::string remedy) {
    Problem problem;
    problem.severity = Severity::Error;
    problem.pointer = std::move(pointer);
    problem.message = std::move(message);
    problem.remedy = std::move(remedy);
    return problem;
}

}  // namespace

Scene withReducedStrength(const Scene& scene, double factor) {
    assert(factor > 0.0);
    Scene reduced = scene;
    if (reducesJoints(scene)) reduceJoints(reduced, factor);
    if (reducesBonds(scene)) reduceBonds(reduced, factor);
    for (Stage& stage : reduced.stages) {
        stage.continueAfterCollapse = false;
        stage.onCollapse = OnCollapse::End;
    }
    return reduced;
}

std::vector<Problem> checkSafety(const Scene& scene) {
    std::vector<Problem> problems;
    if (scene.stages.empty())
        problems.push_back(error("/stages", "the scene has no stages, so there is no equilibrium to find",
                                 "Add a static stage"));
    for (std::size_t i = 0; i < scene.stages.size(); ++i)
        if (scene.stages[i].kind == StageKind::Dynamic)
            problems.push_back(error(under(under("/stages", i), "kind"),
                                     "a dynamic stage has no equilibrium, so it has no factor of safety",
                                     "Remove it and the stages that depend on it, or replace it by a static load"));
    if (reducesBonds(scene) && scene.safety.boltForces == BoltForces::Frozen)
        problems.push_back(error("/safety/bolt_forces",
                                 "the strength of bonds is to be reduced, but frozen bolt forces do not depend on it",
                                 "Reduce joints only, or write \"bolt_forces\": \"mobilised\""));
    const bool joints = reducesJoints(scene) && someJointHasStrength(scene);
    const bool bonds = reducesBonds(scene) && someBondHasStrength(scene);
    if (!joints && !bonds)
        problems.push_back(error("/safety/reduce", "there is no strength to reduce",
                                 "Give joints friction, cohesion or tensile strength, or anchors of bolts a strength, "
                                 "and reduce those"));
    return problems;
}

}  // namespace keyblock
