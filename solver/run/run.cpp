// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run: stage after stage, each increment or step handed to the engine, what
// it finds to the sink.
#include "solver/run/run.h"

#include "solver/engine/bolt_topology.h"
#include "solver/engine/contacts.h"
#include "solver/engine/dynamics.h"
#include "solver/engine/joint_change.h"
#include "solver/engine/statics.h"
#include "solver/results/history.h"
#include "solver/run/observation.h"
#include "solver/run/run_limit.h"
#include "solver/run/stage_loads.h"
#include "solver/run/watch.h"
#include "solver/scene/acceleration.h"
#include "solver/scene/lookup.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace keyblock {
namespace {

constexpr int usualIncrements = 100;
constexpr double longestTimeStep = 1e-3;  // [s], where a stage gives none
constexpr double fewestSteps = 200.0;  // of a dynamic stage that gives no time step

Inertia inertiaOf(Integration integration) {
    switch (integration) {
        case Integration::Shi: return Inertia::Shi;
        case Integration::BackwardEuler: return Inertia::BackwardEuler;
        case Integration::Newmark: return Inertia::Newmark;
        case Integration::GeneralizedAlpha: return Inertia::GeneralizedAlpha;
    }
    return Inertia::Shi;
}

class Runner : StepObserver {
public:
    Runner(const Scene& scene, Sink& sink, Control& control)
        : scene_(scene), sink_(sink), control_(control), limit_(scene.limits), model_(makeModel(scene)),
          state_(makeState(model_)), engine_(model_), loads_(model_, scene), observation_(scene, model_, (place(), state_)),
          watch_(model_, state_) {
        engine_.stopAsked = [this] { return stopAsked(); };
        engine_.passed = [this] { report(); };
    }

    std::vector<StageResult> run() {
        sink_.begin(scene_, historyColumns(scene_));
        std::vector<StageResult> results;
        for (stage_ = 0; stage_ < static_cast<int>(scene_.stages.size()); ++stage_) {
            results.push_back(runStage(scene_.stages[static_cast<std::size_t>(stage_)]));
            sink_.stageEnds(results.back());
            const Outcome outcome = results.back().outcome;
            if (outcome == Outcome::Stopped || outcome == Outcome::Failed || outcome == Outcome::Limit) break;
            if (outcome == Outcome::Collapse && !scene_.stages[static_cast<std::size_t>(stage_)].continueAfterCollapse)
                break;
        }
        return results;
    }

private:
    void place() {
        state_.contacts = findContacts(model_, state_.blocks, {}, model_.size * 1e-3, true);
        placeBolts(model_, state_);
        state_.startEnergy = bookedEnergy(model_, state_);
    }

    StageResult runStage(const Stage& stage) {
        sink_.stageBegins(stage_);
        engine_.health = {};
        time_ = 0.0;
        firstStep_ = state_.step;
        loads_.begin(stage_, state_);
        if (!stage.set.empty()) changeJoints(scene_, stage_, model_, state_);
        if (stage.zeroDisplacements) observation_.zero(state_);
        watch_.beginStage(state_);
        nextFrame_ = 0.0;
        const StepEnding ending = stage.kind == StageKind::Static ? runStatic(stage) : runDynamic(stage);
        loads_.end(loadsReached_);
        return finish(stage, ending);
    }

    StepEnding runStatic(const Stage& stage) {
        state_.energy.damped += kineticEnergy(model_, state_);
        for (BlockMotion& block : state_.blocks) block.velocity.setZero();
        for (BoltMotion& bolt : state_.bolts)
            for (BoltNode& node : bolt.nodes) node.velocity.setZero();
        StaticSettings settings;
        settings.unbalanced = stage.until.unbalanced.value_or(std::min(settings.unbalanced, scene_.analysis.tolerance));
        settings.maxSteps = stage.until.maxSteps.value_or(settings.maxSteps);
        keepFrame(1.0, false);
        LoadPoint before = loads_.start();
        loadsReached_ = before;
        for (double time : timesOf(stage)) {
            if (stopAsked()) return {Ending::Stopped, "", {}};
            const LoadPoint next = loads_.at(time);
            const StepEnding ending =
                advanceStatic(engine_, state_, loads_.loads(), before, next, settings, *this, loadsReached_);
            time_ = loadsReached_.time;
            if (ending.ending != Ending::Done) return ending;
            lookAround();
            keepFrame(1.0, false);
            before = next;
        }
        time_ = 1.0;
        return {};
    }

    /// 0 for what the stage puts on at once, then the increments, with every turn of a table among them.
    std::vector<double> timesOf(const Stage& stage) const {
        std::vector<double> times{0.0};
        if (!loads_.varies() && !stage.increments) return times;
        const int count = stage.increments.value_or(usualIncrements);
        for (int i = 1; i <= count; ++i) times.push_back(static_cast<double>(i) / count);
        for (double turn : loads_.turns()) times.push_back(turn);
        std::sort(times.begin(), times.end());
        times.erase(std::unique(times.begin(), times.end(),
                                [](double a, double b) { return b - a < 1e-12; }),
                    times.end());
        return times;
    }

    StepEnding runDynamic(const Stage& stage) {
        const double before = bookedEnergy(model_, state_);
        for (const InitialVelocity& initial : stage.initialVelocities) setVelocity(initial);
        const Integration integration = stage.integration.value_or(scene_.analysis.integration);
        DynamicSettings settings;
        settings.scheme = inertiaOf(integration);
        settings.rhoInf = stage.rhoInf.value_or(scene_.analysis.rhoInf);
        settings.damping = scene_.analysis.damping;
        const double usual = std::min({longestTimeStep, stage.duration / fewestSteps, longestStepFor(stage)});
        settings.timeStep = stage.timeStep.value_or(usual);
        DynamicStage dynamic(engine_, loads_.loads(), [this](double t) { return loads_.at(t); }, settings);
        StepEnding ending = dynamic.begin(state_);
        state_.startEnergy += bookedEnergy(model_, state_) - before;  // velocities and preload were given
        keepFrame(stage.duration, false);
        while (ending.ending == Ending::Done && time_ < stage.duration) {
            if (stopAsked()) {
                ending = {Ending::Stopped, "", {}};
                break;
            }
            ending = dynamic.step(state_, time_, stage.duration, *this);
            lookAround();
            keepFrame(stage.duration, false);
        }
        loadsReached_ = loads_.at(time_);
        return ending;
    }

    void setVelocity(const InitialVelocity& initial) {
        const auto rock = static_cast<std::size_t>(blockAt(scene_, initial.blockAt));
        const int first = model_.firstOf[rock], end = model_.firstOf[rock + 1];
        Point middle{0.0, 0.0};  // of mass, the block's own or that of its cells
        double mass = 0.0;
        for (int row = first; row < end; ++row) {
            middle += model_.blocks[row].mass * state_.blocks[row].centroid;
            mass += model_.blocks[row].mass;
        }
        for (int row = first; row < end; ++row) {
            BlockMotion& motion = state_.blocks[row];
            const Point away = end - first > 1 ? Point(motion.centroid - middle / mass) : Point(0.0, 0.0);
            const Point velocity = initial.velocity + initial.spin * turnLeft(away);
            motion.velocity.setZero();
            motion.velocity[0] = velocity.dot(motion.axis);
            motion.velocity[1] = velocity.dot(turnLeft(motion.axis));
            motion.velocity[2] = initial.spin;
        }
    }

    StageResult finish(const Stage& stage, const StepEnding& ending) {
        StageResult result;
        result.stage = stage_;
        result.time = time_;
        result.steps = state_.step - firstStep_;
        result.blocks = ending.blocks;
        result.message = ending.message;
        switch (ending.ending) {
            case Ending::Done:
                result.outcome = stage.kind == StageKind::Static ? Outcome::Equilibrium : Outcome::Duration;
                break;
            case Ending::NoEquilibrium: collapse(result); break;
            case Ending::Stopped: stopped(result); break;
            case Ending::Failed: result.outcome = Outcome::Failed; break;
        }
        keepFrame(1.0, true);
        result.health = engine_.health;
        result.health.balanceError = energyOf(model_, state_).balanceError;
        return result;
    }

    void stopped(StageResult& result) const {
        result.outcome = control_.stop ? Outcome::Stopped : Outcome::Limit;
        if (!control_.stop) result.message = limit_.message(state_.step);
    }

    void collapse(StageResult& result) {
        result.outcome = Outcome::Collapse;
        result.message = "no equilibrium: moving are";
        for (int block : result.blocks) result.message += " " + model_.blocks[static_cast<std::size_t>(block)].name;
        Event event;
        event.kind = EventKind::Collapse;
        if (!result.blocks.empty()) {
            event.block = result.blocks.front();
            event.position = state_.blocks[static_cast<std::size_t>(event.block)].centroid;
        }
        beforeEvent(state_, time_);
        this->event(event, state_, time_);
        afterEvent(state_, time_);
    }

    /// Events that need no release, with a history row either side.
    void lookAround() {
        for (Event& event : watch_.look(state_)) {
            beforeEvent(state_, time_);
            this->event(event, state_, time_);
            afterEvent(state_, time_);
        }
    }

    void beforeEvent(const State& state, double time) override { sink_.history(observation_.history(state, stage_, time)); }
    void afterEvent(const State& state, double time) override { sink_.history(observation_.history(state, stage_, time)); }
    void event(Event event, const State& state, double time) override {
        event.stage = stage_;
        event.time = time;
        event.step = state.step;
        event.position += model_.origin;
        watch_.told(event);
        sink_.event(event);
        ++events_;
    }

    /// A frame when one is due; always the stage's last, but never the same twice.
    void keepFrame(double duration, bool last) {
        const bool due = last ? keptStep_ != state_.step || keptStage_ != stage_ : time_ >= nextFrame_ * (1.0 - 1e-12);
        if (!due) return;
        const double every = scene_.output.every.value_or(duration * static_cast<double>(scene_.stages.size()) /
                                                          std::max(1, scene_.output.frames));
        nextFrame_ = (std::floor(time_ * (1.0 + 1e-12) / every) + 1.0) * every;
        keptStep_ = state_.step;
        keptStage_ = stage_;
        sink_.history(observation_.history(state_, stage_, time_));
        sink_.frame(observation_.frame(state_, stage_, time_));
    }

    bool stopAsked() {
        if (control_.pause && !control_.stop) {
            const auto paused = std::chrono::steady_clock::now();
            while (control_.pause && !control_.stop) std::this_thread::sleep_for(std::chrono::milliseconds(10));
            limit_.addPause(std::chrono::steady_clock::now() - paused);
        }
        return control_.stop || limit_.reached(state_.step);
    }

    void report() {
        if (!control_.progress) return;
        const Stage& stage = scene_.stages[static_cast<std::size_t>(stage_)];
        const double share = stage.kind == StageKind::Static ? time_ : time_ / stage.duration;
        Progress progress;
        progress.stage = stage_;
        progress.time = time_;
        progress.fraction = (stage_ + share) / static_cast<double>(scene_.stages.size());
        progress.steps = state_.step;
        progress.passes = engine_.health.passes;
        progress.events = events_;
        progress.residual = engine_.health.maxResidual;
        control_.progress(progress);
    }

    const Scene& scene_;
    Sink& sink_;
    Control& control_;
    RunLimit limit_;
    Model model_;
    State state_;
    Engine engine_;
    StageLoads loads_;
    Observation observation_;
    Watch watch_;
    LoadPoint loadsReached_;
    int stage_ = 0;
    double time_ = 0.0;
    double nextFrame_ = 0.0;
    long firstStep_ = 0, keptStep_ = -1, events_ = 0;
    int keptStage_ = -1;
};

}  // namespace

std::vector<StageResult> run(const Scene& scene, Sink& sink, Control& control, const RunSettings& settings) {
    const std::size_t threads = settings.threads > 0 ? static_cast<std::size_t>(settings.threads)
                                                     : std::max(1u, std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return Runner(scene, sink, control).run();
}

Results runInMemory(const Scene& scene, const RunSettings& settings) {
    MemorySink sink;
    Control control;
    run(scene, sink, control, settings);
    return std::move(sink.results);
}

}  // namespace keyblock
