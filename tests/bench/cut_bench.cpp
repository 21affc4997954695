// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the whole way from 5,000 traces to finished blocks costs beside the bare
// insertion of the same segments into CGAL's arrangement, which no exact cut can
// do without. `ratio` is the one over the other, each the median of the same runs.
#include "geometry/cut/cut.h"
#include "geometry/polygon.h"

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>
#include <random>

namespace keyblock {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Kernel>>;

/// A domain of 1 m, traces about a tenth as long in all directions.
std::vector<CutTrace> randomTraces(int count) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> place(0.0, 1.0), angle(0.0, std::numbers::pi), length(0.04, 0.16);
    std::vector<CutTrace> traces;
    for (int i = 0; i < count; ++i) {
        const Point middle(place(random), place(random));
        const double turn = angle(random);
        const Point half = 0.5 * length(random) * Point(std::cos(turn), std::sin(turn));
        traces.push_back({middle - half, middle + half, i});
    }
    return traces;
}

/// Two sets of persistent joints with a little scatter, as many traces in all.
std::vector<CutTrace> twoSets(int count) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> scatter(0.0, 0.02);
    std::vector<CutTrace> traces;
    for (int i = 0; i < count; ++i) {
        const double turn = (i % 2 ? 0.6 : 2.0) + scatter(random), offset = 1.4 * (i / 2 + 0.5) / (count / 2) - 0.7;
        const Point along(std::cos(turn), std::sin(turn));
        const Point middle = Point(0.5, 0.5) + offset * turnLeft(along);
        traces.push_back({middle - along, middle + along, i % 2});
    }
    return traces;
}

std::size_t bareInsert(const std::vector<Point>& border, const std::vector<CutTrace>& traces) {
    std::vector<Kernel::Segment_2> segments;
    const auto add = [&](const Point& a, const Point& b) {
        segments.emplace_back(Kernel::Point_2(a.x(), a.y()), Kernel::Point_2(b.x(), b.y()));
    };
    for (std::size_t i = 0; i < border.size(); ++i) add(border[i], border[(i + 1) % border.size()]);
    for (const CutTrace& trace : traces) add(trace.from, trace.to);
    Arrangement arrangement;
    CGAL::insert(arrangement, segments.begin(), segments.end());
    return arrangement.number_of_faces();
}

/// Time of the processor, so that a busy machine does not blur the ratio [s].
template <class Work>
double seconds(Work work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

void cutAgainstInsert(benchmark::State& state, const std::vector<CutTrace>& traces) {
    const std::vector<CutDomain> domain{{1, {{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
    std::vector<double> cuts, inserts;
    std::size_t blocks = 0, faces = 0;
    for (auto _ : state) {
        inserts.push_back(seconds([&] { faces = bareInsert(domain.front().outline, traces); }));
        cuts.push_back(seconds([&] { blocks = cutIntoBlocks(domain, traces, {}).blocks.size(); }));
    }
    state.counters["cut_ms"] = 1e3 * median(cuts);
    state.counters["insert_ms"] = 1e3 * median(inserts);
    state.counters["ratio"] = median(cuts) / median(inserts);
    state.counters["blocks"] = static_cast<double>(blocks);
    state.counters["faces"] = static_cast<double>(faces);
}

void cutRandomTraces(benchmark::State& state) {
    cutAgainstInsert(state, randomTraces(static_cast<int>(state.range(0))));
}
void cutTwoSets(benchmark::State& state) { cutAgainstInsert(state, twoSets(static_cast<int>(state.range(0)))); }

BENCHMARK(cutRandomTraces)->Arg(1000)->Arg(5000)->Iterations(9)->Unit(benchmark::kMillisecond);
BENCHMARK(cutTwoSets)->Arg(300)->Iterations(9)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace keyblock
