// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factors of safety of blocks in a roof against closed forms: three scenes of the
// series that `make safety-series` runs as a whole (tests/safety/series.py).
#include "solver/run/safety.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

constexpr double unitWeight = 26e3;  // [N/m³]
constexpr double halfAngle = 25.0, prismFriction = 45.0, stiffnessRatio = 0.4;  // [°], ks/kn
constexpr double prismStress = 76e3;  // [Pa]

/// A block between a line of joints and the roof y = 0, in rock that is held at its top.
Scene roofScene(const std::vector<Point>& line, double left, double right, double top, double frictionAngle) {
    Scene scene = emptyScene(rigidRock, 0.25, frictionAngle);
    scene.analysis = Analysis{};
    scene.analysis.gravity = {0.0, -gravity};
    scene.materials[0].second.density = unitWeight / gravity;
    SceneDomain domain;
    domain.boundary = {{left, 0.0}, {right, 0.0}, {right, top}, {left, top}};
    domain.material = "rock";
    domain.jointMaterial = "joint";
    scene.domain = domain;
    SceneJoint joint;
    joint.name = "block";
    joint.points = line;
    scene.joints = {joint};
    Support support;
    support.boundary = BoundarySide::Top;
    scene.supports = {support};
    Stage stage;
    stage.name = "gravity";
    scene.stages = {stage};
    return scene;
}

double prismHeight() { return 1.0 / std::tan(halfAngle * degree); }

/// A symmetric prism over a base of 2 m, under horizontal stress before gravity acts.
Scene prismScene(double stress) {
    const double height = prismHeight();
    Scene scene = roofScene({{-1.0, 0.0}, {0.0, height}, {1.0, 0.0}}, -3.0, 3.0, 1.4 * height, prismFriction);
    JointMaterial& joint = scene.jointMaterials[0].second;
    joint.normalStiffness = 10e9;
    joint.shearStiffness = stiffnessRatio * 10e9;
    if (stress > 0.0) {
        InSituStress inSitu;
        inSitu.sxx = -stress;
        scene.inSituStress = inSitu;
    }
    return scene;
}

/// Weight that the prism can just carry at a friction angle [rad] (Crawford and Bray 1983; Brady and Brown): with H = σh·h
/// each face has H·cos α across and H·sin α along it, and a prism that sinks loses ks and kn of them.
double carried(double friction) {
    const double a = halfAngle * degree, c = std::cos(a), s = std::sin(a);
    const double stiffness = stiffnessRatio * c * c + s * s;
    const double lost = stiffnessRatio * c * std::cos(friction) + s * std::sin(friction);
    return 2.0 * prismStress * prismHeight() * stiffness * std::sin(friction - a) / lost;
}

/// tan φ / tan φ*, where the prism just carries its own weight at φ*.
double prismFactor() {
    double low = halfAngle * degree, high = 0.5 * std::numbers::pi;
    while (high - low > 1e-12) {
        const double middle = 0.5 * (low + high);
        (carried(middle) > unitWeight * prismHeight() ? high : low) = middle;
    }
    return std::tan(prismFriction * degree) / std::tan(high);
}

SafetyFactor safetyOf(Scene scene, double tolerance) {
    scene.safety.tolerance = tolerance;
    Control control;
    const auto trial = [&](const Scene& reduced, double, Sink& sink) { run(reduced, sink, control); };
    return findSafetyFactor(scene, trial);
}

void expectWithin(const SafetyFactor& found, double expected, double tolerance) {
    ASSERT_TRUE(found.lower && found.upper);
    EXPECT_NEAR(*found.lower, expected, tolerance * expected);
    EXPECT_NEAR(*found.upper, expected, tolerance * expected);
}

TEST(SafetySeries, ARoofPrismHasTheFactorOfItsStiffness) {
    EXPECT_NEAR(prismFactor(), 1.4017, 1e-4);
    expectWithin(safetyOf(prismScene(prismStress), 0.005), prismFactor(), 0.05);
}

TEST(SafetySeries, APrismWithoutStressFallsWhateverTheStrength) {
    const SafetyFactor found = safetyOf(prismScene(0.0), 0.005);
    EXPECT_FALSE(found.lower || found.cutShort);
    EXPECT_EQ(found.upper, leastSafety);
    ASSERT_TRUE(found.mode && found.mode->blocks.size() == 1u);
    EXPECT_EQ(found.mode->blocks[0].movement, Movement::Falls);
}

/// It lies on a joint of 45° and opens one of 32°: tan φ / tan 45°.
TEST(SafetySeries, ABlockSlidesOnOneJointWhileTheOtherOpens) {
    const double steep = 1.0, flat = std::tan(32.0 * degree), height = 1.0 / (1.0 / flat - 1.0 / steep);
    const Point apex(height / flat, height);
    const Scene scene = roofScene({{0.0, 0.0}, apex, {1.0, 0.0}}, -2.0, apex.x() + 2.0, height + 2.0, 40.0);
    expectWithin(safetyOf(scene, 0.002), std::tan(40.0 * degree), 0.01);
}

}  // namespace
}  // namespace keyblock
