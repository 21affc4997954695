// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole runs: the paper's rebar until one side has let go, with the largest memory
// of the process, and a block at rest for a hundred thousand steps, with the
// memory that it took on the way.
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace keyblock {
namespace {

/// Keeps nothing, so that what grows is the solver's own.
class NoSink : public Sink {
public:
    void begin(const Scene&, const HistoryColumns&) override {}
    void stageBegins(int) override {}
    void event(const Event&) override {}
    void history(const HistoryRow&) override {}
    void frame(const Frame&) override {}
    void stageEnds(const StageResult& result) override { steps += result.steps; }

    long steps = 0;
};

Scene sceneOf(SceneReading reading) {
    for (const Problem& problem : reading.problems) std::cerr << problem.message << '\n';
    if (!reading.scene) std::exit(EXIT_FAILURE);
    return std::move(*reading.scene);
}

double residentMegabytes() {
    std::ifstream status("/proc/self/statm");
    long total = 0, resident = 0;
    status >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

double largestMegabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1e3;
}

long solve(const Scene& scene, Control& control) {
    NoSink sink;
    run(scene, sink, control);
    return sink.steps;
}

void rebarStated(benchmark::State& state) {
    const Scene scene = sceneOf(readSceneFile(KEYBLOCK_SAMPLES_DIR "/rebar-stated.json"));
    for (auto _ : state) {
        Control control;
        solve(scene, control);
    }
    state.counters["largest_MB"] = largestMegabytes();
}

constexpr const char* restingBlock = R"({
  "format": "keyblock-scene", "version": 1, "title": "A block at rest",
  "analysis": { "gravity": [0, -9.81] },
  "materials": { "rock": { "density": 2700, "youngs_modulus": 10e9, "poissons_ratio": 0.2 } },
  "blocks": [
    { "name": "floor", "points": [[-2,-1],[2,-1],[2,0],[-2,0]], "material": "rock" },
    { "name": "block", "points": [[-0.5,0],[0.5,0],[0.5,1],[-0.5,1]], "material": "rock" } ],
  "supports": [ { "block_at": [0,-0.5], "fix": "all" } ],
  "stages": [ { "name": "rest", "kind": "dynamic", "duration": 100, "time_step": 0.001 } ]
})";

void blockAtRest(benchmark::State& state) {
    const Scene scene = sceneOf(readSceneText(restingBlock, "block at rest"));
    for (auto _ : state) {
        double early = 0.0;  // after a tenth of the steps everything has its size
        Control control;
        control.progress = [&](const Progress& progress) {
            if (early == 0.0 && progress.fraction >= 0.1) early = residentMegabytes();
        };
        state.counters["steps"] = static_cast<double>(solve(scene, control));
        state.counters["growth_MB"] = residentMegabytes() - early;
    }
}

BENCHMARK(rebarStated)->Unit(benchmark::kSecond);
BENCHMARK(blockAtRest)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace keyblock
