// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What it takes to settle a wall in running bond and a field of Voronoi cells from
// cold, by the defaults: passes, time, and how well the energy closes.
#include "solver/run/run.h"
#include "solver/scene/scene_cut.h"
#include "tests/properties/wall.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

Stage atRest() {
    Stage stage;
    stage.name = "settle";
    stage.kind = StageKind::Static;
    return stage;
}

/// Twice as long as it is high, nearly.
Scene wallOf(int blocks) {
    WallSetting setting;
    setting.rows = static_cast<int>(std::lround(std::sqrt(0.625 * blocks)));
    setting.columns = static_cast<int>(std::lround(static_cast<double>(blocks) / setting.rows));
    Scene scene = brickWall(setting);
    scene.analysis.tolerance = Analysis{}.tolerance;
    scene.stages = {atRest()};
    return scene;
}

/// A square of cells of 1 m², held at its foot and sides.
Scene fieldOf(int blocks) {
    Scene scene = wallOf(1);
    scene.blocks.clear();
    const double side = std::sqrt(static_cast<double>(blocks));
    scene.domain = SceneDomain{{{0, 0}, {side, 0}, {side, side}, {0, side}}, scene.materials.front().first, {}};
    SceneVoronoi voronoi;
    voronoi.size = 1.0;
    voronoi.seed = 1;
    scene.voronoi = voronoi;
    const auto held = [](BoundarySide which, Fix fix) {
        Support support;
        support.boundary = which;
        support.fix = fix;
        return support;
    };
    scene.supports = {held(BoundarySide::Bottom, Fix::XY), held(BoundarySide::Left, Fix::X),
                      held(BoundarySide::Right, Fix::X)};
    return scene;
}

void settle(benchmark::State& state, const Scene& scene) {
    for (auto _ : state) {
        const Results results = runInMemory(scene);
        const StageResult& stage = results.stages.front();
        state.counters["blocks"] = static_cast<double>(results.frames.back().blocks.size());
        state.counters["settled"] = stage.outcome == Outcome::Equilibrium ? 1.0 : 0.0;
        state.counters["passes"] = static_cast<double>(stage.health.passes);
        state.counters["energy_error"] = std::abs(stage.health.balanceError);
    }
}

void wallSettles(benchmark::State& state) { settle(state, wallOf(static_cast<int>(state.range(0)))); }
void fieldSettles(benchmark::State& state) { settle(state, fieldOf(static_cast<int>(state.range(0)))); }

BENCHMARK(wallSettles)->Arg(1000)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(fieldSettles)->Arg(1000)->Arg(5000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace keyblock
