// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the ways to find contacts cost: passes and factorisations of a step by
// the convex minimisation and the open–close iteration, with penalty springs and
// with multipliers, on a wall that stands and on one that slides.
#include "solver/run/run.h"
#include "tests/properties/wall.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

enum Ground { Level, Steep };

Scene wallOn(Ground ground, Iteration iteration, ContactMethod contact, double penalty) {
    WallSetting setting;
    setting.columns = 5;
    setting.rows = 5;
    setting.duration = 0.05;
    if (ground == Steep) {  // 25°
        setting.frictionAngle = 20.0;
        setting.gravity = {9.81 * std::sin(0.4363), -9.81 * std::cos(0.4363)};
    }
    Scene scene = brickWall(setting);
    scene.analysis.tolerance = 1e-4;
    scene.analysis.iteration = iteration;
    scene.analysis.contact = contact;
    scene.analysis.penaltyRatio = penalty;
    return scene;
}

/// Arguments: ground, iteration, contact, penalty ratio.
void wall(benchmark::State& state) {
    const Scene scene =
        wallOn(static_cast<Ground>(state.range(0)), static_cast<Iteration>(state.range(1)),
               static_cast<ContactMethod>(state.range(2)), static_cast<double>(state.range(3)));
    for (auto _ : state) {
        const StageResult result = runInMemory(scene).stages.front();
        const auto steps = static_cast<double>(std::max<long>(1, result.steps));
        state.counters["steps"] = steps;
        state.counters["passes_a_step"] = static_cast<double>(result.health.passes) / steps;
        state.counters["factors_a_step"] = static_cast<double>(result.health.work.factorizations) / steps;
        state.counters["cuts"] = static_cast<double>(result.health.stepCuts);
        state.counters["penetration"] = result.health.maxPenetrationRatio;
        state.counters["settled"] = result.outcome == Outcome::Duration ? 1.0 : 0.0;
    }
}

BENCHMARK(wall)
    ->ArgNames({"steep", "open_close", "multipliers", "penalty"})
    ->ArgsProduct({{Level, Steep}, {0, 1}, {0, 1}, {1, 40}})
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace keyblock
