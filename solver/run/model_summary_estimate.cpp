// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimates the cost of a run. Its time follows from the beginning of the run
// (`forecastRun`), and numbers of iterations from runs of the samples and of jointed
// rock where that does not reach. Measured times affect only what is reported.
#include "solver/run/model_summary.h"

#include "solver/engine/contact/search.h"
#include "solver/engine/stage/limits.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/step_solver.h"
#include "solver/run/run_forecast.h"
#include "solver/run/stage_settings.h"
#include "solver/scene/collapse_stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace keyblock {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double enoughTime = 0.05;  // minimum duration of the timing [s]
constexpr int fewestRounds = 2;  // minimum number of timed rounds, after one that fixes the pattern

// Numbers of iterations found in runs. Samples: 2 to 3 per increment without releases, 5 to 10 per release, 1.0 to 1.6
// per time step. Jointed rock of 110 to 1,000 blocks under gravity: 40 to 360 per search for equilibrium, about 1e4 in
// a search that ends in a collapse, 1.7 to 14 per time step.
constexpr double passesAnIncrement = 3.0, passesARelease = 7.0, passesATimeStep = 1.3;
constexpr double passesARockSearch = 200.0, passesARockStep = 2.8;
constexpr double bandFactor = 2.0;  // of the estimate, either way
// automatic increments of a stage in which joints slide or bolts yield
constexpr int slidingIncrements = 12, flowingIncrements = 50;
constexpr double releasedShare = 0.7;  // fraction of the parts that can fail
// from this number of free blocks, with three contacts each, a scene is jointed rock
constexpr int jointedRock = 20;

constexpr double startSeconds = 0.03;  // to start the program and its run store
constexpr double frameSeconds = 1e-3;  // to store a frame
constexpr double programMemory = 14e6;  // of the program and its libraries [bytes]

double secondsSince(const Clock::time_point& start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Measures the time of steps of the scene at its start, with all parts active.
class Timing {
public:
    Timing(const Model& model, const State& start, const std::atomic<bool>* stop)
        : model_(model), state_(start), stop_(stop) {}

    /// \return false if the measurement was stopped.
    bool measure(CostEstimate& estimate) {
        round();
        pass_ = step_ = 0.0;
        int rounds = 0;
        const auto start = Clock::now();
        while (rounds < fewestRounds || secondsSince(start) < enoughTime) {
            if (stop_ && *stop_) return false;
            round();
            ++rounds;
        }
        estimate.passSeconds = pass_ / rounds;
        estimate.stepSeconds = step_ / rounds;
        estimate.factorEntries = solver_.factorEntries();
        estimate.memory = programMemory + problemMemory_ + 12.0 * estimate.factorEntries;
        return true;
    }

private:
    /// Makes one step with one iteration: contact search, links, factorisation, solution and acceptance.
    void round() {
        auto from = Clock::now();
        State trial = state_;
        trial.contacts = findContacts(model_, trial.blocks, state_.contacts, model_.size * 1e-3, false);
        LoadPoint at;
        at.gravity = 1.0;
        StepOptions options;
        options.inertia = Inertia::Shi;
        options.dt = 1e-3;
        StepProblem problem = buildStep(model_, trial, Loads{}, at, options);
        for (double& value : problem.load) value += problem.floorForce;  // so that there is something to solve for
        step_ += secondsSince(from);
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        from = Clock::now();
        solver_.solve(problem, d, {1e-15, 0, false}, {});
        pass_ += secondsSince(from);
        from = Clock::now();
        d.setZero();
        acceptStep(model_, trial, problem, d);
        heldLimits(model_, trial);
        step_ += secondsSince(from);
        problemMemory_ = memoryOf(problem);
    }

    /// Memory for the links twice (for the step and for its energy balance), for the sums of an iteration, and for five
    /// copies of the state: the last, the trial, the start of an increment, the checkpoint and its bytes.
    double memoryOf(const StepProblem& problem) const {
        const double links = static_cast<double>(problem.links.size());
        double state = static_cast<double>(state_.contacts.size() * sizeof(Contact));
        for (const BlockMotion& block : state_.blocks)
            state += static_cast<double>(sizeof(BlockMotion) + block.corners.size() * sizeof(Point));
        for (const BoltMotion& bolt : state_.bolts)
            state += static_cast<double>(bolt.nodes.size() * (sizeof(BoltNode) + sizeof(BoltElementState)));
        const double bodies = problem.blocks + problem.nodes;
        const double pairs = bodies + 0.5 * links;
        return 2.0 * links * sizeof(Link) + pairs * (36.0 * 24.0 + 36.0 * 4.0) + bodies * 600.0 + 5.0 * state;
    }

    const Model& model_;
    const State& state_;
    const std::atomic<bool>* stop_;
    StepSolver solver_;
    double pass_ = 0.0, step_ = 0.0;
    double problemMemory_ = 0.0;
};

/// The properties of a scene that determine the number of iterations.
struct Nature {
    int releases = 0;  // number of parts that may fail one after another
    bool jointed = false;  // rock with many joints
    bool slides = false;  // a joint may slide
    bool flows = false;  // a bolt may debond or yield
};

/// True for a bond as strong as the rock is stiff, which no strain within the range of the model would break.
bool unbreakable(const Model& model, const State& state, const Limit& limit) {
    const Contact& c = state.contacts[limit.owner];
    const JointModel& joint = model.joints[c.joint];
    const double modulus = std::min(model.blocks[c.blockA].youngsModulus, model.blocks[c.blockB].youngsModulus);
    return std::min(joint.cohesion, joint.tensileStrength) >= modulus;
}

Nature natureOf(const Model& model, const State& start, const ModelCounts& counts) {
    Nature nature;
    const std::vector<Limit> limits = heldLimits(model, start);
    nature.releases = static_cast<int>(std::count_if(limits.begin(), limits.end(), [&](const Limit& limit) {
        if (limit.kind == LimitKind::JointBond) return !unbreakable(model, start, limit);
        return limit.kind == LimitKind::Bond || limit.kind == LimitKind::Yield;
    }));
    const auto slides = [](const Contact& c) { return !c.bonded; };
    nature.slides = std::any_of(start.contacts.begin(), start.contacts.end(), slides);
    nature.flows = std::any_of(limits.begin(), limits.end(), [](const Limit& limit) {
        return limit.kind == LimitKind::Bond || limit.kind == LimitKind::Yield;
    });
    const int free = counts.blocks - counts.cells - counts.fixed;
    nature.jointed = free >= jointedRock && static_cast<int>(start.contacts.size()) >= 3 * free;
    return nature;
}

PlannedStage staticPlan(double increments, const Nature& nature, bool loaded) {
    PlannedStage plan;
    plan.loaded = loaded;
    plan.steps = increments;
    plan.passes = passesAnIncrement * increments + (loaded ? passesARelease * releasedShare * nature.releases : 0.0) +
                  (nature.jointed ? passesARockSearch : 0.0);
    return plan;
}

PlannedStage dynamicPlan(double duration, double timeStep, const Nature& nature) {
    PlannedStage plan;
    plan.dynamic = true;
    plan.duration = duration;
    plan.steps = duration / timeStep;
    plan.passes = plan.steps * (nature.jointed ? passesARockStep : passesATimeStep);
    return plan;
}

/// Expected number of increments of a static stage in which the load changes. Automatic increments depend on what may
/// happen in the scene and on the frames that it requests.
int likelyIncrements(const Scene& scene, const Stage& stage, const Nature& nature) {
    if (stage.increments) return *stage.increments;
    const int frames = static_cast<int>(std::ceil(1.0 / framesEvery(scene, stage).value_or(1.0)));
    return std::max(frames, nature.flows ? flowingIncrements : nature.slides ? slidingIncrements : 1);
}

/// The stages one after another, with increments as in the run. Walls of excavated rock count as a load that changes.
/// A stage that follows a collapse has no steps, because most scenes do not collapse.
std::vector<PlannedStage> planOf(const Scene& scene, const Model& model, State state, const Nature& nature) {
    std::vector<PlannedStage> plan;
    LoadMemory memory;
    StageLoads loads(model, scene, memory);
    bool walls = false;
    for (std::size_t i = 0; i < scene.stages.size(); ++i) {
        Stage stage = scene.stages[i];
        if (stage.followsCollapse) {
            plan.push_back({true, true, stage.duration});
            continue;
        }
        loads.begin(static_cast<int>(i), state);
        if (stage.kind == StageKind::Static) {
            walls = walls || !stage.excavate.empty();
            if (loads.varies() || !stage.excavate.empty() || (walls && stage.relaxation))
                stage.increments = likelyIncrements(scene, stage, nature);
            const auto increments = static_cast<double>(incrementTimes(scene, stage, loads).size());
            plan.push_back(staticPlan(increments, nature, increments > 1.0));
        } else {
            plan.push_back(dynamicPlan(stage.duration, dynamicSettings(scene, stage).timeStep, nature));
        }
        loads.end(loads.at(stage.kind == StageKind::Static ? 1.0 : stage.duration));
    }
    return plan;
}

void addStages(const Scene& scene, const std::vector<PlannedStage>& plan, const RunForecast& forecast,
               CostEstimate& estimate) {
    for (std::size_t i = 0; i < plan.size(); ++i) {
        const ForecastStage& stage = forecast.stages[i];
        if (scene.stages[i].followsCollapse && stage.passes == 0.0) continue;
        StageCost cost;
        cost.name = scene.stages[i].name;
        cost.steps = plan[i].steps;
        cost.passes = stage.passes;
        cost.least = stage.over ? stage.passes : std::max(stage.known, stage.passes / bandFactor);
        cost.most = stage.over ? stage.passes : bandFactor * stage.passes;
        estimate.stages.push_back(cost);
    }
}

void addAssumptions(const Nature& nature, const RunForecast& forecast, CostEstimate& estimate) {
    const auto say = [&](bool applies, std::string text) {
        if (applies) estimate.assumes.push_back(std::move(text));
    };
    say(forecast.whole,
        "The scene was run to its end to measure this, on one thread of this machine; the results were "
        "discarded.");
    say(!forecast.whole,
        "The first half second of the run was made to measure this, on one thread of this machine; the "
        "results were discarded.");
    say(forecast.fromCoarse, "The whole run was made once with fewer elements in the bolts.");
    say(forecast.searching,
        "The search for equilibrium had not ended; rock whose joints slide is assumed to come to rest "
        "in 200 iterations, and a search that ends in a collapse takes up to 50 times as long.");
    say(nature.jointed && !forecast.whole,
        "Later stages are assumed to be like those at the start; a collapse takes "
        "longer.");
}

}  // namespace

std::optional<CostEstimate> estimateCost(const Scene& scene, const Model& model, const State& start,
                                         const ModelCounts& counts, const std::atomic<bool>* stop) {
    CostEstimate estimate;
    const Nature nature = natureOf(model, start, counts);
    if ((stop && *stop) || !Timing(model, start, stop).measure(estimate)) return std::nullopt;
    const Scene run = withCollapseStages(scene);
    if (run.stages.empty()) return estimate;
    const std::vector<PlannedStage> plan = planOf(run, model, start, nature);
    const std::optional<RunForecast> forecast = forecastRun(run, model, plan, stop);
    if (!forecast) return std::nullopt;
    addStages(run, plan, *forecast, estimate);
    addAssumptions(nature, *forecast, estimate);
    double steps = 0.0;
    for (const StageCost& stage : estimate.stages) steps += stage.steps;
    estimate.seconds = forecast->seconds + startSeconds +
                       frameSeconds * std::min<double>(steps, scene.output.frames.value_or(defaultFrames));
    estimate.secondsLeast = std::max(forecast->known, estimate.seconds / bandFactor);
    estimate.secondsMost = bandFactor * estimate.seconds;
    return estimate;
}

}  // namespace keyblock
