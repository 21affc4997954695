// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The beginning of a run gives the pace of blocks in contact: of the stage in
// progress it is continued, of later ones it gives the time of an iteration. Static
// stages in which a load changes are assumed to take as long as those before. A bolt
// that is pulled fails node by node, most of them early, so that its beginning says
// little; but the time of the whole run grows with a power of the number of its nodes,
// so that a run with few of them gives it.
#include "solver/run/run_forecast.h"

#include "solver/engine/setup/make_model.h"

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

/// The run of a scene with fewer elements in its bolts.
struct CoarseRun {
    PilotRun pilot;
    double growth = 1.0;  // time of the scene over that of this run
};

/// \param whole set if the run reached its end. \return false if `stop` became true.
bool runCoarse(const Scene& scene, const Model& model, const std::atomic<bool>* stop, std::optional<CoarseRun>& whole) {
    const Scene coarse = withCoarseBolts(scene);
    std::optional<PilotRun> run = pilotRun(coarse, coarseSeconds, stop);
    if (!run) return false;
    if (!run->whole) return true;
    const bool given = std::any_of(scene.bolts.begin(), scene.bolts.end(),
                                   [](const Bolt& bolt) { return bolt.divisions.has_value(); });
    const double growth = std::pow(nodesOf(model) / nodesOf(makeModel(coarse)),
                                   given ? powerOfGiven : powerOfAutomatic);
    whole = {std::move(*run), growth};
    return true;
}

class Forecaster {
public:
    Forecaster(const PilotRun& pilot, const std::optional<CoarseRun>& coarse, const std::vector<PlannedStage>& planned)
        : pilot_(pilot), coarse_(coarse), planned_(planned), passSeconds_(timeOfAPass()) {}

    RunForecast make() {
        forecast_.stages.resize(planned_.size());
        forecast_.whole = pilot_.whole;
        forecast_.known = pilot_.seconds;
        forecast_.fromCoarse = coarse_.has_value();
        for (const PilotStage& stage : pilot_.stages) addBegun(stage);
        if (!pilot_.whole)
            for (std::size_t i = pilot_.stages.back().stage + 1; i < planned_.size(); ++i) addLater(i);
        for (const ForecastStage& stage : forecast_.stages) forecast_.seconds += stage.seconds;
        return std::move(forecast_);
    }

private:
    double timeOfAPass() const {
        const PilotStage& last = pilot_.stages.back();
        if (last.latePasses >= 3) return last.lateSeconds / static_cast<double>(last.latePasses);
        long passes = 0;
        for (const PilotStage& stage : pilot_.stages) passes += stage.passes;
        return pilot_.seconds / static_cast<double>(std::max(1L, passes));
    }

    /// Time of a stage in the coarse run, at the number of elements of the scene; null if it did not run.
    std::optional<double> coarseTime(int stage) const {
        if (!coarse_) return std::nullopt;
        for (const PilotStage& one : coarse_->pilot.stages)
            if (one.stage == stage) return coarse_->growth * one.seconds;
        return std::nullopt;
    }

    /// Mean time of the earlier static stages in which a load changes; null if there was none.
    std::optional<double> meanLoadedTime() const {
        if (loadedStages_.empty()) return std::nullopt;
        return std::accumulate(loadedStages_.begin(), loadedStages_.end(), 0.0) /
               static_cast<double>(loadedStages_.size());
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
        if (const auto mean = planned.loaded ? meanLoadedTime() : std::nullopt)
            return std::max(*mean - stage.seconds, stage.seconds);
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
        else result.seconds = meanLoadedTime().value_or(planned.passes * passSeconds_);
        result.passes = result.seconds / passSeconds_;
    }

    const PilotRun& pilot_;
    const std::optional<CoarseRun>& coarse_;
    const std::vector<PlannedStage>& planned_;
    double passSeconds_;
    std::vector<double> loadedStages_;  // times of static stages in which a load changes
    RunForecast forecast_;
};

}  // namespace

std::optional<RunForecast> forecastRun(const Scene& scene, const Model& model, const std::vector<PlannedStage>& planned,
                                       const std::atomic<bool>* stop) {
    const std::optional<PilotRun> pilot = pilotRun(scene, pilotSeconds, stop);
    if (!pilot) return std::nullopt;
    std::optional<CoarseRun> coarse;
    const bool isStatic = !planned[pilot->stages.back().stage].dynamic;
    if (!pilot->whole && isStatic && boltsDominate(model) && !runCoarse(scene, model, stop, coarse))
        return std::nullopt;
    return Forecaster(*pilot, coarse, planned).make();
}

RunForecast forecastFrom(const PilotRun& pilot, const std::vector<PlannedStage>& planned) {
    return Forecaster(pilot, std::nullopt, planned).make();
}

}  // namespace keyblock
