// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Roof blocks that are supported by horizontal in-situ stress: the conditions
// under which they begin to fall. The scenes are domains under in-situ stress,
// cut by joints.
#include "solver/verify/bisection.h"
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <cmath>
#include <string>
#include <tuple>

namespace keyblock {

namespace {

constexpr double unitWeight = 26e3;  // [N/m³]

/// A domain from the roof line y = 0 up to `top`, between `left` and `right`, under the horizontal stress −`stress`
/// [Pa]. The caller adds the joints that cut it.
Scene roofScene(double left, double right, double top, double stress, double frictionAngle) {
    Scene scene = emptyScene(rigidRock, 0.25, frictionAngle);
    scene.analysis.gravity = {0.0, -gravity};
    scene.materials[0].second.density = unitWeight / gravity;
    SceneDomain domain;
    domain.boundary = {{left, 0.0}, {right, 0.0}, {right, top}, {left, top}};
    domain.material = "rock";
    domain.jointMaterial = "joint";
    scene.domain = domain;
    InSituStress inSitu;
    inSitu.sxx = -stress;
    scene.inSituStress = inSitu;
    Stage stage;
    stage.name = "gravity";
    scene.stages = {stage};
    return scene;
}

SceneJoint joint(const std::string& name, const std::vector<Point>& points) {
    SceneJoint joint;
    joint.name = name;
    joint.points = points;
    return joint;
}

void holdSide(Scene& scene, BoundarySide side) {
    Support support;
    support.boundary = side;
    scene.supports.push_back(support);
}

/// 1 if the roof is stable, 0 if it collapses, NaN if the run ends otherwise.
double holds(const Scene& scene) {
    const Results results = solve(scene).results;
    if (results.stages.empty()) return std::nan("");
    const Outcome outcome = results.stages.back().outcome;
    return outcome == Outcome::Equilibrium ? 1.0 : outcome == Outcome::Collapse ? 0.0 : std::nan("");
}

/// A column 1 m wide and 2 m high between two walls that are fixed at their outer sides.
Scene plugScene(double stress, double frictionAngle) {
    Scene scene = roofScene(-2.0, 3.0, 2.0, stress, frictionAngle);
    scene.joints = {joint("left", {{0.0, 0.0}, {0.0, 2.0}}), joint("right", {{1.0, 0.0}, {1.0, 2.0}})};
    holdSide(scene, BoundarySide::Left);
    holdSide(scene, BoundarySide::Right);
    return scene;
}

/// The walls are vertical and do not move, so the stress on them does not change: γ·b·h = 2·σh·h·tan φ, independent of
/// h.
std::vector<CaseResult> plug() {
    Checks checks("roof plug");
    const double stress = 50e3, width = 1.0;
    const double expected = std::atan(unitWeight * width / (2.0 * stress)) / degree;
    checks.absolute("closed form [°]", expected, 14.574, 1e-3);
    const double found = boundaryOf(10.0, 20.0, 0.01, [&](double phi) { return holds(plugScene(stress, phi)); });
    checks.absolute("friction angle below which it falls [°]", found, expected, 0.3);
    return checks.take();
}

constexpr double halfAngle = 20.0, prismFriction = 40.0;  // [°]
constexpr double halfBase = 1.0;  // [m]

double prismHeight() { return halfBase / std::tan(halfAngle * degree); }

Scene prismScene(double stiffnessRatio, double stress) {
    Scene scene = roofScene(-3.0, 3.0, 4.0, stress, prismFriction);
    JointMaterial& material = scene.jointMaterials[0].second;
    material.normalStiffness = 10e9;
    material.shearStiffness = stiffnessRatio * 10e9;
    scene.joints = {joint("prism", {{-halfBase, 0.0}, {0.0, prismHeight()}, {halfBase, 0.0}})};
    holdSide(scene, BoundarySide::Top);
    return scene;
}

/// The smallest stress that supports the prism (Crawford and Bray 1983; Brady and Brown). Initially each face, at an
/// angle α to the vertical, carries the normal force H·cos α and the shear force H·sin α, with H = σh·h. If the prism
/// moves down by u, the normal force decreases by kn·u·sin α and the shear force increases by ks·u·cos α. Friction is
/// exceeded at the weight W =
///     2·H·(ks·cos²α + kn·sin²α)·sin(φ − α) / (ks·cos α·cos φ + kn·sin α·sin φ).
double prismStress(double ratio) {
    const double a = halfAngle * degree, f = prismFriction * degree;
    const double weight = unitWeight * halfBase * prismHeight();
    const double stiffness = ratio * std::cos(a) * std::cos(a) + std::sin(a) * std::sin(a);
    const double lost = ratio * std::cos(a) * std::cos(f) + std::sin(a) * std::sin(f);
    return weight * lost / (2.0 * stiffness * std::sin(f - a)) / prismHeight();
}

std::vector<CaseResult> prism() {
    Checks checks("roof prism");
    checks.relative("weight [N]", unitWeight * halfBase * prismHeight(), 71.43e3, 1e-3);
    for (const auto& [ratio, text, published] :
         {std::tuple{1.0, "1", 35.72e3}, {0.4, "0.4", 41.05e3}, {0.1, "0.1", 54.04e3}}) {
        const std::string where = std::string(" at Ks/Kn ") + text + " [Pa]";
        checks.relative("closed form" + where, prismStress(ratio), published, 1e-3);
        const double found =
            boundaryOf(20e3, 80e3, 50.0, [ratio = ratio](double stress) { return holds(prismScene(ratio, stress)); });
        checks.relative("smallest stress that holds it" + where, found, published, 0.05);
    }
    return checks.take();
}

}  // namespace

std::vector<Case> roofCases() {
    return {
        {"roof prism", "A roof prism supported by in-situ stress, with joints of three stiffness ratios.", prism},
        {"roof plug", "A vertical-sided block in a roof supported only by friction on its sides.", plug},
    };
}

}  // namespace keyblock
