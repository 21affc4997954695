// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search only needs to know whether a run is stable. Only the first and last
// frames of a stage are kept, because many runs with many frames would fill the
// memory.
#include "solver/run/safety.h"

#include "solver/run/frozen_bolts.h"
#include "solver/run/strength_reduction.h"

#include <algorithm>
#include <array>
#include <utility>

namespace keyblock {

namespace {

/// Keeps the first and the last frame of the decisive stage, or of every stage.
class DecisiveStage : public Sink {
public:
    explicit DecisiveStage(bool keepsAll) : keepsAll_(keepsAll) {}

    void begin(const Scene&, const HistoryColumns&) override {}
    void stageBegins(int) override {}
    void event(const Event&) override {}
    void history(const HistoryRow&) override {}
    void frame(const Frame& frame) override {
        if (decided_) return;
        if (!first || first->stage != frame.stage) first = frame;
        last = frame;
    }
    void stageEnds(const StageResult& result) override {
        if (decided_) return;
        end = result;
        stands = result.outcome == Outcome::Equilibrium;
        decided_ = !stands;
        if (keepsAll_ && first) all.push_back({*first, *last});
    }

    std::optional<Frame> first, last;
    std::vector<StageFrames> all;
    StageResult end;
    bool stands = false;

private:
    bool keepsAll_, decided_ = false;
};

bool isCutShort(const StageResult& end) { return end.outcome == Outcome::Stopped || end.outcome == Outcome::Limit; }

}  // namespace

std::optional<double> nextSafetyFactor(std::optional<double> lower, std::optional<double> upper, double tolerance,
                                       std::size_t undecided) {
    constexpr std::array within{0.5, 0.25, 0.75}, beside{1.0, 0.9, 1.1};
    if (undecided >= within.size()) return std::nullopt;
    if (!lower && !upper) return beside[undecided];
    if (!upper) return *lower < mostSafety ? std::optional(std::min(2.0 * beside[undecided] * *lower, mostSafety)) : std::nullopt;
    if (!lower) return *upper > leastSafety ? std::optional(std::max(0.5 * beside[undecided] * *upper, leastSafety)) : std::nullopt;
    return *upper - *lower > tolerance ? std::optional(*lower + within[undecided] * (*upper - *lower)) : std::nullopt;
}

SafetyFactor findSafetyFactor(const Scene& scene, const SafetyTrial& trial,
                              const std::function<void(const SafetyRun&)>& report) {
    SafetyFactor found;
    const bool freezes = scene.safety.boltForces == BoltForces::Frozen;
    std::optional<Scene> frozen;  // scene with frozen bolt forces, once the run at factor 1 has ended
    std::size_t undecided = 0;
    while (const auto factor = nextSafetyFactor(found.lower, found.upper, scene.safety.tolerance, undecided)) {
        const bool toFreeze = freezes && !frozen;
        DecisiveStage stage(toFreeze);
        trial(withReducedStrength(frozen ? *frozen : scene, *factor), *factor, stage);
        if (isCutShort(stage.end)) {
            found.cutShort = stage.end.outcome;
            return found;
        }
        const SafetyRun one{*factor, stage.stands, stage.end};
        const bool decided = stage.end.outcome != Outcome::Undecided;
        undecided = decided ? 0 : undecided + 1;
        if (decided) (one.stands ? found.lower : found.upper) = *factor;
        if (decided && !one.stands && stage.first)
            found.mode = failureMode(*stage.first, *stage.last, scene.analysis.gravity);
        found.runs.push_back(one);
        if (report) report(one);
        if (!toFreeze) continue;
        found.nothingToFreeze = decided && !one.stands;
        if (!one.stands) break;
        frozen = withFrozenBolts(scene, stage.all);
    }
    if (undecided > 0) found.cutShort = Outcome::Undecided;
    return found;
}

}  // namespace keyblock
