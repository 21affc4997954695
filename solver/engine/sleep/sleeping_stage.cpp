// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/sleep/sleeping_stage.h"

#include "solver/engine/stage/step_build.h"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

constexpr long sleepEvery = 10;  // steps between times at which blocks may fall asleep
constexpr int mostWakings = 3;  // repetitions of a step with more blocks, after which all wake
constexpr double reachShare = 0.25;  // of the smallest block's size: minimum range of a part around what is awake
constexpr double reachAhead = 4.0;  // times the range of the contact search of one step

/// Passes events of a part on as events of the whole scene.
class PartObserver : public StepObserver {
public:
    PartObserver(const ScenePart& part, const State& whole, StepObserver& observer)
        : part_(part), whole_(whole), observer_(observer) {}

    void beforeEvent(const State& state, double time) override { observer_.beforeEvent(inWhole(state), time); }
    void afterEvent(const State& state, double time) override { observer_.afterEvent(inWhole(state), time); }

    long event(Event event, const State& state, double time) override {
        any_ = true;
        event.block = part_.wholeBlock(event.block);
        event.otherBlock = part_.wholeBlock(event.otherBlock);
        event.bolt = part_.wholeBolt(event.bolt);
        return observer_.event(event, inWhole(state), time);
    }

    bool hadEvents() const { return any_; }

private:
    State inWhole(const State& state) const {
        State whole = whole_;
        part_.writeBack(state, whole);
        return whole;
    }

    const ScenePart& part_;
    const State& whole_;
    StepObserver& observer_;
    bool any_ = false;
};

/// Changes of the forces on the blocks of a part, per block of the whole scene.
void addInWhole(const ScenePart& part, const BlockForces& own, std::size_t blocks, BlockForces& changes) {
    if (changes.empty()) changes.assign(blocks, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < own.size(); ++i) changes[part.wholeBlock(static_cast<int>(i))] += own[i];
}

}  // namespace

SleepingStage::SleepingStage(Engine& engine, std::unique_ptr<PartInUse>& part, const Loads& loads,
                             std::function<LoadPoint(double)> loadsAt, const DynamicSettings& settings, double tolerance)
    : engine_(engine), part_(part), loads_(loads), loadsAt_(loadsAt), settings_(settings),
      whole_(engine, loads, std::move(loadsAt), settings), tolerance_(tolerance) {}

StepEnding SleepingStage::begin(State& state) {
    return whole_.begin(state);
}

SleepLimits SleepingStage::limitsAt(double time) const {
    return {tolerance_, settings_.timeStep, tolerance_ > 0.0 ? weightPerMass(engine_.model, loadsAt_(time)) : 0.0};
}

StepEnding SleepingStage::step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer) {
    if (pace.dt == 0.0) pace.dt = settings_.timeStep;
    const double dt = std::min(pace.dt, end - time);
    if (loadsAt_(time + dt).openings != state.openings) wakeAll(state);
    const StepEnding ending = anyAsleep(state) ? stepOfPart(state, time, end, pace, observer)
                                               : stepOfWhole(state, time, end, pace, observer);
    if (ending.ending != Ending::Done || tolerance_ <= 0.0 || state.step % sleepEvery != 0) return ending;
    if (fallAsleep(engine_.model, loads_, state)) part_.reset();
    return ending;
}

StepEnding SleepingStage::stepOfWhole(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer) {
    part_.reset();
    FoundStep found;
    const StepEnding ending = whole_.find(state, time, end, pace, found);
    if (ending.ending != Ending::Done) return ending;
    const double dt = found.dt;
    whole_.take(std::move(found), state, time, end, pace, observer);
    count(engine_, dt, time, state);
    return ending;
}

/// Counts the quiet steps after a step that ended at `time`. While loads change, nothing comes to rest.
void SleepingStage::count(const Engine& engine, double dt, double time, State& state) const {
    if (tolerance_ <= 0.0) return;
    if (isSameForce(loadsAt_(time - dt), loadsAt_(time)))
        return countQuietSteps(engine.model, engine.taken.d, dt, limitsAt(time), state);
    for (BlockMotion& block : state.blocks) block.rest.quietSteps = 0;
}

StepEnding SleepingStage::stepOfPart(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer) {
    const Model& model = engine_.model;
    for (int wakings = 0;; ++wakings) {
        if (wakings == mostWakings) wakeAll(state);
        if (!anyAsleep(state)) return stepOfWhole(state, time, end, pace, observer);
        DynamicPace next = pace;
        FoundStep found;
        State own;
        double dt = std::min(pace.dt, end - time);
        const bool still = isAllAsleep(model, state);
        const Health health = engine_.health;
        if (!still) {
            prepare(state, dt, pace);
            own = part_->part.stateOf(state);
            const StepEnding ending = find(own, time, end, next, found);
            if (ending.ending == Ending::Stopped) return ending;
            if (ending.ending != Ending::Done || next.dt < pace.dt) {  // perhaps because of what is held
                engine_.health.stepCuts = health.stepCuts;
                engine_.health.energyCuts = health.energyCuts;
                wakeAll(state);
                continue;
            }
            if (!part_->part.holds(state, partStage().searchRange(own, found.dt, next))) {
                part_.reset();
                pace.lastMove = next.lastMove;
                continue;
            }
            dt = found.dt;
        }
        BlockForces changes = loadChanges(model, state, loads_, loadsAt_(time), loadsAt_(time + dt));
        if (!still)
            addInWhole(part_->part, linkChanges(part_->part.model(), found.taken.problem, found.taken.d),
                       model.blocks.size(), changes);
        if (wakeDisturbed(model, limitsAt(time + dt), changes, state)) {
            part_.reset();
            continue;
        }
        addChanges(changes, state);
        pace = next;
        if (still) pass(state, time, end, pace);
        else take(std::move(found), state, std::move(own), time, end, pace, observer);
        return {};
    }
}

/// Lets the time of a step pass in which nothing moves.
void SleepingStage::pass(State& state, double& time, double end, DynamicPace& pace) const {
    part_.reset();
    const double rest = end - time;
    const double dt = pace.dt >= rest * (1.0 - 1e-9) ? rest : pace.dt;
    time = later(time, dt, end, pace.roundedUp);
    pace.dt = std::min(2.0 * pace.dt, settings_.timeStep);
    pace.lastMove = 0.0;
    ++state.step;
}

DynamicStage SleepingStage::partStage() const {
    PartInUse& part = *part_;
    return {part.engine, part.part.loads(), [this, &part](double time) { return part.part.loadsAt(loadsAt_(time)); },
            settings_};
}

/// Makes the part again if what is awake may leave the range for which it was made.
void SleepingStage::prepare(const State& state, double dt, const DynamicPace& pace) {
    const double ahead = whole_.searchRange(state, std::min(dt, settings_.timeStep), pace);
    if (part_ && part_->part.holds(state, ahead)) return;
    const double reach = std::max(reachShare * engine_.model.smallest, reachAhead * ahead);
    part_ = std::make_unique<PartInUse>(engine_.model, state, loads_, reach);
    part_->engine.stopAsked = engine_.stopAsked;
}

StepEnding SleepingStage::find(const State& own, double time, double end, DynamicPace& pace, FoundStep& found) {
    Engine& engine = part_->engine;
    engine.passed = [this, &engine] {
        engine_.health = engine.health;
        engine_.newest = engine.newest;
        engine_.newest.worst = part_->part.wholeBlock(engine.newest.worst);
        engine_.newest.penetrated = part_->part.wholeBlock(engine.newest.penetrated);
        if (engine_.passed) engine_.passed();
    };
    engine.health = engine_.health;
    StepEnding ending = partStage().find(own, time, end, pace, found);
    engine_.health = engine.health;
    for (std::vector<int>* blocks : {&ending.blocks, &ending.followers})
        for (int& block : *blocks) block = part_->part.wholeBlock(block);
    return ending;
}

void SleepingStage::take(FoundStep found, State& state, State own, double& time, double end, DynamicPace& pace,
                         StepObserver& observer) {
    ScenePart& part = part_->part;
    Engine& engine = part_->engine;
    const double dt = found.dt;
    const LoadPoint at = loadsAt_(time + factorsOf(found.taken.options).loadTime * dt);
    PartObserver inWhole(part, state, observer);
    engine.health = engine_.health;
    part_->at = at;
    partStage().take(std::move(found), own, time, end, pace, inWhole);
    engine_.health = engine.health;
    const TakenStep& taken = engine.taken;
    count(engine, dt, time, own);
    if (inWhole.hadEvents()) {
        BlockForces changes, released = linkForces(part.model(), taken.problem, taken.d);
        for (Eigen::Vector3d& force : released) force = -force;
        addInWhole(part, released, state.blocks.size(), changes);
        const StepProblem now = buildStep(part.model(), own, part.loads(), part.loadsAt(at), {Inertia::None});
        addInWhole(part, linkForces(part.model(), now), state.blocks.size(), changes);
        addChanges(changes, state);
    }
    part.writeBack(own, state);
}

std::optional<State> stateBefore(const Engine& engine, const PartInUse* part, const State& now) {
    if (part && part->engine.taken.step == now.step) {
        State before = now;
        part->part.writeBack(part->engine.taken.before, before);
        return before;
    }
    if (engine.taken.step == now.step) return engine.taken.before;
    return std::nullopt;
}

std::optional<TakenStep> lastStep(const Engine& engine, const PartInUse* part, const Loads& loads, const State& now) {
    if (part && part->engine.taken.step == now.step)
        return part->part.inWhole(engine.model, loads, part->at, part->engine.taken, now);
    if (engine.taken.step == now.step) return engine.taken;
    return std::nullopt;
}

}  // namespace keyblock
