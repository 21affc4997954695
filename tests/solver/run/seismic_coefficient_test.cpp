// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A constant body acceleration in static stages: a seismic coefficient that is put
// on and taken off in proportion to pseudo-time, checked against closed forms.
#include "solver/run/run.h"

#include "solver/verify/bisection.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using test::settle;

constexpr double slopeAngle = 10.0, slopeFriction = 25.0;  // [°]
constexpr double mass = 2700.0;  // [kg] of 1 m²

/// Horizontal towards the down-slope side, in axes whose x runs down the slope.
Acceleration horizontal(double coefficient) {
    Acceleration acceleration;
    acceleration.value = coefficient;
    acceleration.axis = {std::cos(slopeAngle * degree), std::sin(slopeAngle * degree)};
    acceleration.factor = gravity;
    return acceleration;
}

/// A box on a slope: first its weight alone, then a horizontal coefficient.
Scene seismicScene(double coefficient) {
    Scene scene = test::boxOnBase(slopeAngle, slopeFriction);
    scene.stages = {settle(), settle()};
    scene.stages[1].name = "seismic";
    scene.stages[1].bodyAcceleration = horizontal(coefficient);
    return scene;
}

/// 1 where the box stands, 0 where it collapses, NaN where the run ends otherwise.
double stands(double coefficient) {
    const Results results = solve(seismicScene(coefficient)).results;
    if (results.stages.size() != 2 || results.stages[0].outcome != Outcome::Equilibrium) return std::nan("");
    const Outcome outcome = results.stages[1].outcome;
    return outcome == Outcome::Equilibrium ? 1.0 : outcome == Outcome::Collapse ? 0.0 : std::nan("");
}

/// The force in proportion to the mass of the box at a pseudo-time of a stage, over its mass [m/s²].
Point accelerationIn(const Solved& solved, int stage, double time) {
    for (const Frame& frame : solved.results.frames)
        if (frame.stage == stage && std::abs(frame.time - time) < 1e-9) return frame.forces.bodies.at(1).weight / mass;
    return {std::nan(""), std::nan("")};
}

/// W (sin α + k cos α) = W (cos α − k sin α) tan φ, so k = tan(φ − α). Read from the other side: 1 where it slides.
TEST(SeismicCoefficient, ABlockOnASlopeSlidesAtTheCriticalOne) {
    const double critical = std::tan((slopeFriction - slopeAngle) * degree);
    const double found = boundaryOf(0.2, 0.35, 5e-4, [](double k) { return 1.0 - stands(k); });
    EXPECT_NEAR(found, critical, 0.002 * critical);
}

TEST(SeismicCoefficient, IsPutOnAndTakenOffInProportion) {
    Scene scene = seismicScene(0.2);
    scene.stages.push_back(settle());
    scene.stages[2].name = "after";
    scene.output.every = 0.25;
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 3u);
    for (const StageResult& stage : solved.results.stages) EXPECT_EQ(stage.outcome, Outcome::Equilibrium);
    const Point full = 0.2 * gravity * scene.stages[1].bodyAcceleration->axis.normalized();
    for (const double time : {0.25, 0.5, 0.75, 1.0}) {
        EXPECT_NEAR((accelerationIn(solved, 1, time) - scene.analysis.gravity - time * full).norm(), 0.0, 1e-9) << time;
        EXPECT_NEAR((accelerationIn(solved, 2, time) - scene.analysis.gravity - (1.0 - time) * full).norm(), 0.0, 1e-9)
            << time;
    }
}

/// A second coefficient is reached from the first one, not from zero.
TEST(SeismicCoefficient, ChangesFromOneStageToTheNext) {
    Scene scene = seismicScene(0.2);
    scene.stages.push_back(scene.stages[1]);
    scene.stages[2].name = "more";
    scene.stages[2].bodyAcceleration->value = 0.25;
    scene.output.every = 0.5;
    const Solved solved = solve(scene);
    const Point axis = scene.stages[1].bodyAcceleration->axis.normalized();
    const Point middle = accelerationIn(solved, 2, 0.5) - scene.analysis.gravity;
    EXPECT_NEAR((middle - 0.225 * gravity * axis).norm(), 0.0, 1e-9);
}

/// A dynamic stage starts without it, and what acts in a dynamic stage ends with it.
TEST(SeismicCoefficient, EndsWhereMotionBegins) {
    Scene scene = seismicScene(0.2);
    scene.stages.push_back(test::dynamic(0.01, 1e-3));
    scene.stages[2].bodyAcceleration = horizontal(0.1);
    scene.stages.push_back(test::dynamic(0.01, 1e-3));
    scene.stages[3].name = "free";
    scene.stages.push_back(settle());
    scene.stages[4].name = "rest";
    scene.output.every = 0.005;
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 5u);
    const Point small = 0.1 * gravity * scene.stages[1].bodyAcceleration->axis.normalized();
    EXPECT_NEAR((accelerationIn(solved, 2, 0.01) - scene.analysis.gravity - small).norm(), 0.0, 1e-9);
    EXPECT_NEAR((accelerationIn(solved, 3, 0.01) - scene.analysis.gravity).norm(), 0.0, 1e-9);
    EXPECT_NEAR((accelerationIn(solved, 4, 1.0) - scene.analysis.gravity).norm(), 0.0, 1e-9);
}

/// Without gravity it is all that presses the box on its base.
TEST(SeismicCoefficient, NeedsNoGravity) {
    Scene scene = test::boxOnBase(0.0, slopeFriction);
    scene.analysis.gravity = {0.0, 0.0};
    scene.stages = {settle()};
    Acceleration down;
    down.value = -3.0;
    down.axis = {0.0, 1.0};
    scene.stages[0].bodyAcceleration = down;
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.back().outcome, Outcome::Equilibrium);
    double pressed = 0.0;
    for (const ContactFrame& contact : solved.results.frames.back().contacts) pressed += contact.normalForce;
    EXPECT_NEAR(pressed, 3.0 * mass, 3e-3 * mass);
}

}  // namespace
}  // namespace keyblock
