// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A hundred steps of walls at rest and of walls that slide, after they have settled:
// time, and the counted work and factorizations of a solve in motion (theory, "Sweeps
// over the contact forces").
#include "solver/run/run.h"
#include "tests/properties/wall.h"

#include <benchmark/benchmark.h>

namespace keyblock {
namespace {

void solve(benchmark::State& state, const Scene& scene) {
    Health health;
    for (auto _ : state) health = runInMemory(scene).stages.back().health;
    const double solves = static_cast<double>(health.steps);
    state.counters["work"] = workOf(health.work) / solves;
    state.counters["factorizations"] = static_cast<double>(health.work.factorizations) / solves;
    state.counters["step_cuts"] = static_cast<double>(health.stepCuts + health.energyCuts);
}

void wallAtRest(benchmark::State& state) {
    solve(state, settledWall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
}

void wallThatSlides(benchmark::State& state) {
    solve(state, tiltedWall(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
}

BENCHMARK(wallAtRest)->Args({20, 13})->Args({40, 26})->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(wallThatSlides)->Args({20, 13})->Args({40, 26})->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
}  // namespace keyblock
