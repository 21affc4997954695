// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factor and solve on the pattern of a brick wall: six unknowns a block, each tied
// to its neighbours in its row and in the next.
#include "solver/engine/step/linear_system.h"

#include <benchmark/benchmark.h>

#include <cstdlib>

namespace keyblock {
namespace {

std::vector<std::pair<int, int>> wallPattern(int side) {
    std::vector<std::pair<int, int>> entries;
    const auto tie = [&](int a, int b) {
        for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) entries.emplace_back(6 * b + i, 6 * a + j);
    };
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const int block = row * side + column;
            tie(block, block);
            if (column + 1 < side) tie(block, block + 1);
            if (row + 1 < side) tie(block, block + side);
            if (row + 1 < side && column + 1 < side) tie(block, block + side + 1);
        }
    return entries;
}

LinearSystem wall(int side) {
    LinearSystem system;
    const auto entries = wallPattern(side);
    system.analyse(6 * side * side, entries);
    for (const auto& [i, j] : entries)
        system.values()[system.slot(i, j)] = i == j ? 100.0 : -0.5 - 0.1 * ((i * 7 + j * 3) % 5);
    return system;
}

void factor(benchmark::State& state) {
    LinearSystem system = wall(static_cast<int>(state.range(0)));
    for (auto _ : state)
        if (system.factor() != -1) std::abort();
    state.counters["unknowns"] = system.size();
}

void solve(benchmark::State& state) {
    LinearSystem system = wall(static_cast<int>(state.range(0)));
    if (system.factor() != -1) std::abort();
    const std::vector<double> load(system.size(), 1.0);
    std::vector<double> x(load.size());
    for (auto _ : state) system.solve(load, x);
    state.counters["unknowns"] = system.size();
}

BENCHMARK(factor)->Arg(3)->Arg(10)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK(solve)->Arg(3)->Arg(10)->Arg(32)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace keyblock
