// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/extremes/scene_parts.h"

#include "solver/results/run_source.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

Scene conditionedScene(const Conditions& c) {
    Scene scene;
    scene.analysis.plane = c.plane;
    scene.analysis.thickness = c.thickness;
    scene.analysis.gravity = {0.0, -c.gravity};
    scene.analysis.integration = c.integration;
    scene.analysis.contact = c.contact;
    scene.analysis.iteration = c.iteration;
    scene.analysis.penaltyRatio = c.penalty;
    scene.analysis.shearRatio = c.shearRatio;
    scene.analysis.tolerance = c.tolerance;
    scene.analysis.maxPasses = static_cast<int>(c.iterations);
    scene.analysis.damping.mass = c.damping;
    scene.materials = {{"rock", {c.density, c.modulus, c.poisson}},
                       {"base", {c.density, c.modulus * c.contrast, c.poisson}}};
    JointMaterial joint;
    joint.frictionAngle = c.friction;
    joint.cohesion = c.cohesion;
    scene.jointMaterials = {{"joint", joint}};
    scene.output.frames = 4;
    return scene;
}

void addBase(Scene& scene, const Point& low, const Point& high) {
    Block base = boxBlock("base", low, high);
    base.material = "base";
    scene.blocks.push_back(base);
    Support support;
    support.blockAt = 0.5 * (low + high);
    scene.supports.push_back(support);
}

Stage conditionedMotion(const Conditions& c) {
    Stage stage;
    stage.name = "motion";
    stage.kind = StageKind::Dynamic;
    stage.timeStep = c.timeStep;
    stage.duration = c.timeStep * std::round(c.steps);
    return stage;
}

Stage conditionedRest() {
    Stage stage;
    stage.name = "rest";
    return stage;
}

double weightOf(const Conditions& c, double width, double height) {
    return c.density * c.gravity * width * height * c.size * c.size * c.thickness;
}

double contactStiffness(const Conditions& c) { return c.penalty * c.modulus * std::min(1.0, c.contrast) * c.thickness; }

double restingDeflection(const Conditions& c) {
    const double weight = weightOf(c);
    return weight / (2.0 * contactStiffness(c)) + weight / (4.0 * c.modulus * c.thickness);
}

double lastTime(const Solved& solved) { return solved.results.frames.back().time; }

const BlockState& lastBlock(const Solved& solved, std::size_t index) {
    return solved.results.frames.back().blocks.at(index);
}

Point moved(const Conditions& conditions, const Solved& solved, std::size_t index) {
    return inOwnAxes(conditions, lastBlock(solved, index).displacement);
}

ContactSums contactsBetween(const Solved& solved, int a, int b) {
    ContactSums sums;
    for (const ContactFrame& contact : solved.results.frames.back().contacts)
        if (std::minmax(contact.blockA, contact.blockB) == std::minmax(a, b)) {
            sums.normal += contact.normalForce;
            sums.shear += std::abs(contact.shearForce);
        }
    return sums;
}

Point contactForceOn(const Conditions& conditions, const Solved& solved, int block) {
    Point sum(0.0, 0.0);
    for (const ContactFrame& contact : solved.results.frames.back().contacts) {
        if (contact.blockA != block && contact.blockB != block) continue;
        const Point right(contact.normal.y(), -contact.normal.x());
        const Point onA = contact.normalForce * contact.normal + contact.shearForce * right;
        sum += contact.blockA == block ? onA : Point(-onA);
    }
    return inOwnAxes(conditions, sum);
}

double contactClosure(const Conditions& c, double force) {
    return c.contact == ContactMethod::AugmentedLagrangian ? 0.0 : force / (2.0 * contactStiffness(c));
}

bool endedWell(const Solved& solved) {
    return solved.results.stages.size() == solved.scene.stages.size() &&
           std::all_of(solved.results.stages.begin(), solved.results.stages.end(),
                       [](const StageResult& stage) { return endedAsPlanned(stage.outcome); });
}

bool endedUnstable(const Solved& solved) {
    return !solved.results.stages.empty() && endedUnstable(solved.results.stages.back().outcome);
}

double forceShare(const Conditions& conditions) { return std::clamp(10.0 * conditions.tolerance, 1e-3, 0.02); }

double axialForce(const Solved& solved) {
    double largest = 0.0;
    for (const BoltNodeFrame& node : solved.results.frames.back().bolts.front().nodes)
        largest = std::max(largest, std::abs(node.axialForce));
    return largest;
}

}  // namespace keyblock
