// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_point.h"

#include "solver/engine/setup/make_model.h"
#include "solver/results/result_names.h"
#include "solver/run/model_summary.h"
#include "solver/scene/preset.h"
#include "solver/trade/peak_memory.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <thread>

namespace keyblock {

namespace {

constexpr double movedShare = 0.1;  // of a block's size: a block that moved farther counts as moved
constexpr std::size_t mostMonitors = 4;  // whose quantities are proposed

/// Keeps the last frame only.
class LastFrameSink : public MemorySink {
public:
    void frame(const Frame& frame) override { results.frames.assign(1, frame); }
};

ModelCounts countsOf(const Scene& solved) {
    const Model model = makeModel(solved);
    return countParts(model, makeState(model));
}

int blocksMoved(const Results& results) {
    if (results.frames.empty()) return 0;
    const Frame& last = results.frames.back();
    int moved = 0;
    for (std::size_t i = 0; i < std::min(last.blocks.size(), last.blockExtremes.size()); ++i)
        if (last.blockExtremes[i].displacement.value > movedShare * std::sqrt(last.blocks[i].area)) ++moved;
    return moved;
}

std::string failureOf(const Scene& scene, const Results& results) {
    for (const StageResult& result : results.stages)
        if (!endedAsPlanned(result.outcome) && !endedUnstable(result.outcome))
            return "stage '" + stageName(scene, result.stage) + "' ended as " + std::string(wordOf(result.outcome)) +
                   (result.message.empty() ? "" : ": " + result.message);
    return {};
}

bool wasStopped(const Results& results) {
    return std::any_of(results.stages.begin(), results.stages.end(),
                       [](const StageResult& result) { return result.outcome == Outcome::Stopped; });
}

void addWork(const Results& results, TradePoint& point) {
    for (const StageResult& result : results.stages) {
        point.steps += result.steps;
        point.passes += result.health.passes;
        point.work += result.health.work;
    }
}

/// A clock for runs. With one thread it is the CPU time of this thread: other programs prolong the wall-clock time of
/// some runs and not of others.
double tradeSeconds(int threads) {
    timespec now{};
    clock_gettime(threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void proposeEvents(const Results& results, std::vector<std::string>& quantities) {
    for (const EventKindRow& row : eventKinds) {
        const auto count = std::count_if(results.events.begin(), results.events.end(),
                                         [&](const Event& event) { return event.kind == row.kind && event.bolt >= 0; });
        if (count == 0) continue;
        // the numbers of the others follow the divisions of the bolts
        if (row.severity >= graveSeverity) quantities.push_back("count " + std::string(row.key));
        quantities.push_back("order " + std::string(row.key));
    }
}

}  // namespace

int mostLoadedBolt(const Results& results) {
    int most = -1;
    double largest = 0.0;
    if (results.frames.empty()) return most;
    const std::vector<BoltExtremes>& bolts = results.frames.back().extremes;
    for (std::size_t b = 0; b < bolts.size(); ++b)
        if (std::abs(bolts[b].axialForce.value) > largest) {
            largest = std::abs(bolts[b].axialForce.value);
            most = static_cast<int>(b);
        }
    return most;
}

std::vector<std::string> proposedQuantities(const Scene& scene, const Results& results) {
    std::vector<std::string> quantities{"stands", "energy_error"};
    for (std::size_t i = 0; i < std::min(mostMonitors, scene.monitors.size()); ++i) {
        const Monitor& monitor = scene.monitors[i];
        // after a rupture the last force of a bolt is round-off
        quantities.push_back((monitor.bolt ? "max " : "last ") + monitor.name + (monitor.point ? ".u" : ""));
    }
    if (const int bolt = mostLoadedBolt(results); bolt >= 0) {
        quantities.push_back("max " + scene.bolts[bolt].name + ".axial_force");
        quantities.push_back("max " + scene.bolts[bolt].name + ".debonded_length");
    }
    proposeEvents(results, quantities);
    return quantities;
}

std::optional<TradePoint> measurePoint(const Scene& scene, const TradeSetting& setting,
                                       std::vector<std::string>& quantities, const TradeRun& run) {
    Scene changed = scene;
    setting.apply(changed);
    const SceneCut cut = cutScene(changed);
    TradePoint point;
    point.axis = setting.axis;
    point.setting = setting.text;
    point.overrides = setting.overrides;
    point.preset = presetText(changed.analysis);
    point.threads = setting.threads;
    point.size = setting.size;
    point.unknowns = countsOf(cut.scene).unknowns();
    LastFrameSink sink;
    resetPeakMemory();
    const double start = tradeSeconds(setting.threads);
    run(changed, cut, setting.threads, sink);
    point.seconds = tradeSeconds(setting.threads) - start;
    point.memory = peakMemory();
    const Results& results = sink.results;
    if (results.stages.empty() || wasStopped(results)) return std::nullopt;
    addWork(results, point);
    point.blocksMoved = blocksMoved(results);
    point.failure = failureOf(cut.scene, results);
    if (quantities.empty())
        quantities = scene.quantities.empty() ? proposedQuantities(cut.scene, results) : scene.quantities;
    for (const std::string& quantity : quantities) point.values.push_back(measure(quantity, cut.scene, results));
    return point;
}

TradeModel tradeModelOf(const Scene& scene) {
    const ModelCounts counts = countsOf(cutScene(scene).scene);
    return {counts.blockUnknowns + counts.plateUnknowns, counts.bolts, counts.boltUnknowns,
            static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))};
}

}  // namespace keyblock
