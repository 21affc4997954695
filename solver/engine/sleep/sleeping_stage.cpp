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
constexpr long stepsAPass = 10;  // number of steps in which nothing moves that counts as one iteration
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

/// Per body of a step, blocks first, then bolt nodes: true if it sleeps.
std::vector<char> sleepingBodies(const Model& model, const State& state) {
    std::vector<char> sleeping;
    for (const BlockMotion& block : state.blocks) sleeping.push_back(block.rest.asleep);
    const std::vector<char> bolts = awakeBolts(model, state);
    for (std::size_t b = 0; b < bolts.size(); ++b)
        sleeping.insert(sleeping.end(), model.bolts[b].s.size(), acts(state.bolts[b]) && !bolts[b]);
    return sleeping;
}

/// Replaces the changes of the forces on the blocks of the part.
/// \param now the forces of their links. \param changes per block of the whole scene.
void takeChanges(const PartInUse& use, const BlockForces& now, BlockForces& changes) {
    for (std::size_t i = 0; i < now.size(); ++i)
        changes[use.part.wholeBlock(static_cast<int>(i))] = now[i] - use.before[i];
}

/// Takes a change of the loads as one of the forces when the blocks fell asleep, so that those of the links include it.
void addLoads(const BlockForces& loads, PartInUse& use) {
    for (std::size_t i = 0; i < use.before.size(); ++i)
        use.before[i] -= loads[use.part.wholeBlock(static_cast<int>(i))];
}

/// True if a step left everything as it was, so that a step under the same loads would do the same.
bool changedNothing(const TakenStep& taken, const State& now) {
    return taken.d.isZero(0.0) && isSameConfiguration(taken.before, now);
}

}  // namespace

SleepingStage::SleepingStage(Engine& engine, std::unique_ptr<PartInUse>& part, const Loads& loads,
                             std::function<LoadPoint(double)> loadsAt, const DynamicSettings& settings,
                             double tolerance)
    : engine_(engine), part_(part), loads_(loads), loadsAt_(loadsAt), settings_(settings),
      whole_(engine, loads, std::move(loadsAt), settings), tolerance_(tolerance) {}

StepEnding SleepingStage::begin(State& state, bool inMotion) { return whole_.begin(state, inMotion); }

SleepLimits SleepingStage::limitsAt(double time) const {
    return {tolerance_, settings_.timeStep, tolerance_ > 0.0 ? weightPerMass(engine_.model, loadsAt_(time)) : 0.0};
}

StepEnding SleepingStage::step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer) {
    if (pace.dt == 0.0) pace.dt = settings_.timeStep;
    const double dt = std::min(pace.dt, end - time);
    if (pace.still ? isSameLoad(loadsAt_(time), loadsAt_(time + dt)) : staysAsleep(state, time, dt)) {
        pass(state, time, end, pace);
        return {};
    }
    pace.still = false;
    const std::vector<double> openings = loadsAt_(time + dt).openings;
    const bool dilates = !openings.empty() && openings != state.openings;
    if (dilates || !limitsAt(time + dt).allow()) wakeAllAt(time, state);
    if (tolerance_ > 0.0 && state.step % sleepEvery == 0) fallAsleepAt(time, state);
    return anyAsleep(state) ? stepOfPart(state, time, end, pace, observer)
                            : stepOfWhole(state, time, end, pace, observer);
}

void SleepingStage::fallAsleepAt(double time, State& state) {
    std::vector<char> may = mayFallAsleep(engine_.model, loads_, state);
    if (std::none_of(may.begin(), may.end(), [](char one) { return one; })) return;
    if (fallAsleep(engine_.model, loads_, loadsAt_(time), limitsAt(time), std::move(may), state)) part_.reset();
}

/// Gives what has woken the accelerations with which it starts, if the scheme uses any.
/// \param slept per body of a step: it slept before.
void SleepingStage::startMoving(const std::vector<char>& slept, double time, State& state) const {
    const std::vector<char> now = sleepingBodies(engine_.model, state);
    std::vector<char> woken(slept.size(), 0);
    for (std::size_t i = 0; i < slept.size(); ++i) woken[i] = slept[i] && !now[i];
    whole_.setAccelerations(state, time, woken);
}

void SleepingStage::wakeAllAt(double time, State& state) const {
    if (!anyAsleep(state)) return;
    const std::vector<char> slept = sleepingBodies(engine_.model, state);
    wakeAll(state);
    startMoving(slept, time, state);
}

bool SleepingStage::wakeDisturbedAt(double time, double dt, const BlockForces& changes, State& state) const {
    const std::vector<char> slept = sleepingBodies(engine_.model, state);
    if (!wakeDisturbed(engine_.model, limitsAt(time + dt), changes, state)) return false;
    startMoving(slept, time, state);
    return true;
}

StepEnding SleepingStage::stepOfWhole(State& state, double& time, double end, DynamicPace& pace,
                                      StepObserver& observer) {
    part_.reset();
    FoundStep found;
    StepEnding ending = whole_.find(state, time, end, pace, found);
    if (ending.ending != Ending::Done) return ending;
    const double dt = found.dt;
    whole_.take(std::move(found), state, time, end, pace, observer);
    count(engine_, dt, time, state);
    pace.still = changedNothing(engine_.taken, state) && isSameLoad(loadsAt_(time - dt), loadsAt_(time));
    return ending;
}

/// Counts the quiet steps after a step that ended at `time`. While loads change, nothing comes to rest.
void SleepingStage::count(const Engine& engine, double dt, double time, State& state) const {
    const SleepLimits limits = limitsAt(time);
    if (tolerance_ <= 0.0) return;
    if (limits.allow() && isSameForce(loadsAt_(time - dt), loadsAt_(time)))
        return countQuietSteps(engine.model, engine.taken.d, dt, limits, state);
    for (BlockMotion& block : state.blocks) block.rest.quietSteps = 0;
}

StepEnding SleepingStage::stepOfPart(State& state, double& time, double end, DynamicPace& pace,
                                     StepObserver& observer) {
    const Model& model = engine_.model;
    engine_.solver.forgetTrend();  // of the last step of the whole
    for (int wakings = 0;; ++wakings) {
        if (wakings == mostWakings) wakeAllAt(time, state);
        if (!anyAsleep(state)) return stepOfWhole(state, time, end, pace, observer);
        DynamicPace next = pace;
        FoundStep found;
        State own;
        double dt = std::min(pace.dt, end - time);
        const bool still = isAllAsleep(model, state);
        const Health health = engine_.health;
        if (!still) {
            prepare(state, time, dt, pace);
            own = part_->part.stateOf(state);
            StepEnding ending = find(own, time, end, next, found);
            if (ending.ending == Ending::Stopped) return ending;
            if (ending.ending != Ending::Done || next.dt < pace.dt) {  // perhaps because of what is held
                engine_.health.stepCuts = health.stepCuts;
                engine_.health.energyCuts = health.energyCuts;
                wakeAllAt(time, state);
                continue;
            }
            if (!part_->part.holds(state, partStage().searchRange(own, found.dt, next))) {
                part_.reset();
                pace.lastMove = next.lastMove;
                continue;
            }
            dt = found.dt;
        }
        BlockForces changes = changesOf(state);
        if (!still) takeChanges(*part_, linkForces(part_->part.model(), found.taken.problem, found.taken.d), changes);
        const BlockForces loads = loadChanges(model, state, loads_, loadsAt_(time), loadsAt_(time + dt));
        for (std::size_t i = 0; i < loads.size(); ++i) changes[i] += loads[i];
        if (wakeDisturbedAt(time, dt, changes, state)) {
            part_.reset();
            continue;
        }
        setChanges(changes, state);
        pace = next;
        if (still) {
            pass(state, time, end, pace);
            return {};
        }
        if (!loads.empty()) addLoads(loads, *part_);
        take(std::move(found), state, std::move(own), time, end, pace, observer);
        return {};
    }
}

/// True if every block slept over the previous step and the loads are still the same, so that nothing can wake. The
/// blocks are not looked at, because a scene at rest should cost the same whatever its size.
bool SleepingStage::staysAsleep(const State& state, double time, double dt) const {
    if (engine_.passedStep != state.step) return false;
    const LoadPoint now = loadsAt_(time), next = loadsAt_(time + dt);
    return isSameForce(now, next) && (next.openings.empty() || next.openings == state.openings);
}

/// Lets the time of a step pass in which nothing moves.
void SleepingStage::pass(State& state, double& time, double end, DynamicPace& pace) const {
    part_.reset();
    const double rest = end - time;
    const double dt = pace.dt >= rest * (1.0 - 1e-9) ? rest : pace.dt;
    time = later(time, dt, end, pace.roundedUp);
    lengthenStep(pace, pace.dt, settings_.timeStep);
    pace.lastMove = 0.0;
    engine_.passedStep = ++state.step;
    if (state.step % stepsAPass == 0) ++engine_.health.passes;
    if (engine_.passed) engine_.passed();
}

DynamicStage SleepingStage::partStage() const {
    PartInUse& part = *part_;
    return {part.engine, part.part.loads(), [this, &part](double time) { return part.part.loadsAt(loadsAt_(time)); },
            settings_};
}

/// Makes the part again if what is awake may leave the range for which it was made.
void SleepingStage::prepare(const State& state, double time, double dt, const DynamicPace& pace) {
    const double ahead = whole_.searchRange(state, std::min(dt, settings_.timeStep), pace);
    if (part_ && part_->part.holds(state, ahead)) return;
    const double reach = std::max(reachShare * engine_.model.smallest, reachAhead * ahead);
    part_ = std::make_unique<PartInUse>(engine_.model, state, loads_, reach);
    part_->engine.stopAsked = engine_.stopAsked;
    const ScenePart& part = part_->part;
    part_->before = linkForces(part.model(), buildStep(part.model(), part.stateOf(state), part.loads(),
                                                       part.loadsAt(loadsAt_(time)), {Inertia::None}));
    for (std::size_t i = 0; i < part_->before.size(); ++i)
        part_->before[i] -= state.blocks[part.wholeBlock(static_cast<int>(i))].rest.change;
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
    engine.passed = nullptr;
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
    count(engine, dt, time, own);
    if (inWhole.hadEvents()) {
        BlockForces changes = changesOf(state);
        const StepProblem now = buildStep(part.model(), own, part.loads(), part.loadsAt(at), {Inertia::None});
        takeChanges(*part_, linkForces(part.model(), now), changes);
        setChanges(changes, state);
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
