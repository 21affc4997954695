// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The default tolerance in motion: right for a light block beside a heavy fast one,
// and blind to the size of masses and to places (theory, "Tolerance").
#include "solver/run/run.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

const double frictionCoefficient = std::tan(30.0 * std::numbers::pi / 180.0);

InitialVelocity thrown(const Point& at, const Point& velocity) {
    InitialVelocity initial;
    initial.blockAt = at;
    initial.velocity = velocity;
    return initial;
}

/// A pebble of 1 cm slides on a slab from 1 m/s to a stop; `heavy` [m] falls beside it at 30 m/s.
Scene pebble(double heavy, double scale = 1.0, const Point& origin = {0.0, 0.0}) {
    Scene scene = emptyScene(10e9 * scale, 0.2, 30.0);
    scene.materials[0].second.density *= scale;
    scene.analysis.tolerance = 1e-4;
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("slab", {-5, -1}, {10, 0}), boxBlock("pebble", {0, 0}, {0.01, 0.01})};
    if (heavy > 0.0) scene.blocks.push_back(boxBlock("heavy", {20, 0}, {20 + heavy, heavy}));
    for (Block& block : scene.blocks)
        for (Point& p : block.points) p += origin;
    Support support;
    support.blockAt = origin + Point(0.0, -0.5);
    scene.supports = {support};
    Stage stage;
    stage.name = "slide";
    stage.kind = StageKind::Dynamic;
    stage.duration = 0.25;
    stage.timeStep = 1e-3;
    stage.initialVelocities = {thrown(origin + Point(0.005, 0.005), {1.0, 0.0})};
    if (heavy > 0.0)
        stage.initialVelocities.push_back(thrown(origin + Point(20 + 0.5 * heavy, 0.5 * heavy), {0.0, -30.0}));
    scene.stages = {stage};
    return scene;
}

double slid(const Results& results) { return results.frames.back().blocks[1].displacement.x(); }

/// v²/2μg, whatever falls beside it.
TEST(Tolerance, ALightBlockIsRightBesideAHeavyOne) {
    const double alone = slid(runInMemory(pebble(0.0)));
    const double expected = 1.0 / (2.0 * frictionCoefficient * gravity);
    EXPECT_NEAR(alone, expected, 2e-3 * expected);
    for (const double heavy : {0.01, 1.0, 10.0, 100.0})
        EXPECT_NEAR(slid(runInMemory(pebble(heavy))), alone, 1e-6 * alone) << heavy;
}

/// Masses and stiffness alike a million times larger or smaller: the same motion at the same cost. A mile away the
/// digits of the places are all that changes.
TEST(Tolerance, KnowsNoUnitsAndNoPlaces) {
    const Results one = runInMemory(pebble(10.0));
    for (const double scale : {1e-6, 1e6}) {
        const Results other = runInMemory(pebble(10.0, scale));
        EXPECT_NEAR(slid(other), slid(one), 1e-9 * slid(one)) << scale;
        EXPECT_EQ(other.stages[0].health.passes, one.stages[0].health.passes) << scale;
    }
    const Results away = runInMemory(pebble(10.0, 1.0, {1600.0, -1600.0}));
    EXPECT_NEAR(slid(away), slid(one), 1e-6 * slid(one));
    EXPECT_NEAR(static_cast<double>(away.stages[0].health.passes), static_cast<double>(one.stages[0].health.passes),
                0.05 * static_cast<double>(one.stages[0].health.passes));
}

}  // namespace
}  // namespace keyblock
