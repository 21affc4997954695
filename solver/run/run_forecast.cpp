// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The beginning of a run gives the pace of blocks in contact: of the stage in
// progress it is continued, of later ones it gives the time of an iteration. A bolt
// that is pulled fails node by node, most of them early, so that its beginning says
// little; but the time of the whole run grows with a power of the number of its nodes,
// so that a run with few of them gives it.
#include "solver/run/run_forecast.h"

#include "solver/engine/setup/make_model.h"
#include "solver/run/pilot_run.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keyblock {
namespace {

// CPU times of the runs [s]
constexpr double pilotSeconds = 0.5, coarseSeconds = 0.7;
// elements of a bolt in the coarse run: of automatic ones, and of others as a share of those given
constexpr int coarseElements = 15, coarserGiven = 4;
// The time of pulled and sheared bolts grows with a power of the number of nodes. Rebars and D-bolts pulled at angles of
// 20 to 90°, from 15 to 120 equal elements: 1.1 to 2.0; from 15 equal ones to automatic ones: 1.8 to 2.4.
constexpr double powerOfGiven = 1.7, powerOfAutomatic = 2.1;

constexpr double shownTime = 0.05;  // share of a static stage from which its pace is continued
constexpr long shownSteps = 5;  // steps in motion, likewise
constexpr double passesAQuietSearch = 10.0;  // rock at rest that nothing loads: 1 to 20

double nodesOf(const Model& model) {
    std::size_t nodes = 0;
    for (const BoltModel& bolt : model.bolts) nodes += bolt.s.size();
    return static_cast<double>(nodes);
}

bool boltsDominate(const Model& model) {
    const auto free = [](const BlockModel& block) { return !block.fixed; };
    return nodesOf(model) > 4.0 * static_cast<double>(std::count_if(model.blocks.begin(), model.blocks.end(), free));
}

/// The scene with fewer elements in its bolts.
Scene withCoarseBolts(Scene scene) {
    for (Bolt& bolt : scene.bolts)
        bolt.divisions = bolt.divisions
                             ? std::max(std::min(coarseElements, *bolt.divisions), *bolt.divisions / coarserGiven)
                             : coarseElements;
    return scene;
}

class Forecaster {
public:
    Forecaster(const Scene& scene, const Model& model, const std::vector<PlannedStage>& planned,
               const std::atomic<bool>* stop)
        : scene_(scene), model_(model), planned_(planned), stop_(stop) {}

    std::optional<RunForecast> make() {
        std::optional<PilotRun> pilot = pilotRun(scene_, pilotSeconds, stop_);
        if (!pilot) return std::nullopt;
        pilot_ = std::move(*pilot);
        const bool isStatic = !planned_[pilot_.stages.back().stage].dynamic;
        if (!pilot_.whole && isStatic && boltsDominate(model_) && !addCoarse()) return std::nullopt;
        forecast_.stages.resize(planned_.size());
        forecast_.whole = pilot_.whole;
        forecast_.known = pilot_.seconds;
        passSeconds_ = timeOfAPass();
        for (const PilotStage& stage : pilot_.stages) addBegun(stage);
        if (!pilot_.whole)
            for (std::size_t i = pilot_.stages.back().stage + 1; i < planned_.size(); ++i) addLater(i);
        for (const ForecastStage& stage : forecast_.stages) forecast_.seconds += stage.seconds;
        return std::move(forecast_);
    }

private:
    /// Runs the scene with coarser bolts. \return false if that was stopped.
    bool addCoarse() {
        const Scene scene = withCoarseBolts(scene_);
        const std::optional<PilotRun> run = pilotRun(scene, coarseSeconds, stop_);
        if (!run) return false;
        if (!run->whole) return true;
        coarse_ = *run;
        const bool given = std::any_of(scene_.bolts.begin(), scene_.bolts.end(),
                                       [](const Bolt& bolt) { return bolt.divisions.has_value(); });
        growth_ = std::pow(nodesOf(model_) / nodesOf(makeModel(scene)), given ? powerOfGiven : powerOfAutomatic);
        forecast_.fromCoarse = true;
        return true;
    }

    double timeOfAPass() const {
        const PilotStage& last = pilot_.stages.back();
        if (last.latePasses >= 3) return last.lateSeconds / static_cast<double>(last.latePasses);
        long passes = 0;
        for (const PilotStage& stage : pilot_.stages) passes += stage.passes;
        return pilot_.seconds / static_cast<double>(std::max(1L, passes));
    }

    /// Time of a stage in the coarse run, at the number of elements of the scene; null if it did not run.
    std::optional<double> coarseTime(int stage) const {
        for (const PilotStage& one : coarse_.stages)
            if (one.stage == stage) return growth_ * one.seconds;
        return std::nullopt;
    }

    void addBegun(const PilotStage& stage) {
        ForecastStage& result = forecast_.stages[stage.stage];
        result.over = stage.over;
        result.known = static_cast<double>(stage.passes);
        result.seconds = stage.over ? stage.seconds : stage.seconds + left(stage);
        result.passes = stage.over ? result.known : result.known + (result.seconds - stage.seconds) / passSeconds_;
        const PlannedStage& planned = planned_[stage.stage];
        if (!planned.dynamic && planned.loaded) loadedStages_.push_back(result.seconds);
    }

    /// Time that a stage in progress still takes.
    double left(const PilotStage& stage) {
        const PlannedStage& planned = planned_[stage.stage];
        if (const auto whole = coarseTime(stage.stage)) return std::max(0.0, *whole - stage.seconds);
        const double rest = planned.duration - stage.time;
        if (planned.dynamic) {
            if (stage.steps >= shownSteps && stage.lateTime > 0.0) return rest * stage.lateSeconds / stage.lateTime;
            return rest / planned.duration * planned.passes * passSeconds_;
        }
        if (stage.time >= shownTime) return rest / stage.time * stage.seconds;
        forecast_.searching = stage.time == 0.0;
        return std::max(planned.passes - static_cast<double>(stage.passes), static_cast<double>(stage.passes)) *
               passSeconds_;
    }

    void addLater(std::size_t i) {
        const PlannedStage& planned = planned_[i];
        ForecastStage& result = forecast_.stages[i];
        if (const auto whole = coarseTime(static_cast<int>(i))) result.seconds = *whole;
        else if (planned.dynamic) result.seconds = planned.passes * passSeconds_;
        else if (!planned.loaded) result.seconds = std::min(planned.passes, passesAQuietSearch) * passSeconds_;
        else if (!loadedStages_.empty())
            result.seconds = std::accumulate(loadedStages_.begin(), loadedStages_.end(), 0.0) /
                             static_cast<double>(loadedStages_.size());
        else result.seconds = planned.passes * passSeconds_;
        result.passes = result.seconds / passSeconds_;
    }

    const Scene& scene_;
    const Model& model_;
    const std::vector<PlannedStage>& planned_;
    const std::atomic<bool>* stop_;
    PilotRun pilot_;
    PilotRun coarse_;  // empty if there is none
    double growth_ = 1.0;  // time of the scene over that of the coarse run
    double passSeconds_ = 0.0;
    std::vector<double> loadedStages_;  // times of static stages in which a load changes
    RunForecast forecast_;
};

}  // namespace

std::optional<RunForecast> forecastRun(const Scene& scene, const Model& model, const std::vector<PlannedStage>& planned,
                                       const std::atomic<bool>* stop) {
    return Forecaster(scene, model, planned, stop).make();
}

}  // namespace keyblock
