// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search knows only whether a run stands. Of the runs themselves nothing is
// kept but two frames, because many runs of many frames would fill the memory.
#include "solver/run/safety.h"

#include "solver/run/strength_reduction.h"

#include <algorithm>
#include <utility>

namespace keyblock {

namespace {

/// Keeps the first and the last frame of the stage that decides.
class DecisiveStage : public Sink {
public:
    explicit DecisiveStage(const Scene& scene) : scene_(scene) {}

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
        stands = result.outcome == Outcome::Equilibrium && !leftItsPlace(result.stage);
        decided_ = !stands;
    }

    std::optional<Frame> first, last;
    StageResult end;
    bool stands = false;

private:
    /// Where something is driven, moving far is what was asked for.
    bool leftItsPlace(int stage) const {
        const Stage& own = scene_.stages[static_cast<std::size_t>(stage)];
        return own.motions.empty() && own.dilations.empty() && first && farthestMovement(*first, *last) > leftPlace;
    }

    const Scene& scene_;
    bool decided_ = false;
};

bool isCutShort(const StageResult& end) { return end.outcome == Outcome::Stopped || end.outcome == Outcome::Limit; }

}  // namespace

std::optional<double> nextSafetyFactor(std::optional<double> lower, std::optional<double> upper, double tolerance) {
    if (!lower && !upper) return 1.0;
    if (!upper) return *lower < mostSafety ? std::optional(std::min(2.0 * *lower, mostSafety)) : std::nullopt;
    if (!lower) return *upper > leastSafety ? std::optional(std::max(0.5 * *upper, leastSafety)) : std::nullopt;
    return *upper - *lower > tolerance ? std::optional(0.5 * (*lower + *upper)) : std::nullopt;
}

SafetyFactor findSafetyFactor(const Scene& scene, const SafetyTrial& trial,
                              const std::function<void(const SafetyRun&)>& told) {
    SafetyFactor found;
    while (const auto factor = nextSafetyFactor(found.lower, found.upper, scene.safety.tolerance)) {
        DecisiveStage stage(scene);
        trial(withReducedStrength(scene, *factor), *factor, stage);
        if (isCutShort(stage.end)) {
            found.cutShort = stage.end.outcome;
            return found;
        }
        const SafetyRun one{*factor, stage.stands, stage.end};
        (one.stands ? found.lower : found.upper) = *factor;
        if (!one.stands && stage.first) found.mode = failureMode(*stage.first, *stage.last, scene.analysis.gravity);
        found.runs.push_back(one);
        if (told) told(one);
    }
    return found;
}

}  // namespace keyblock
