// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a scene stage by stage: each increment or step is passed to the engine, and its
// results to the sink. A single checkpoint, on which the loop works, contains
// everything on which a step depends. After fixed amounts of work, data derived from
// it are discarded and the checkpoint is handed out, so that a run resumed from there
// gives identical results.
#include "solver/run/run.h"

#include "solver/engine/bolt/topology.h"
#include "solver/engine/boundary.h"
#include "solver/engine/contact/joint_change.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/in_situ.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/activation.h"
#include "solver/engine/sleep/sleeping_stage.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/time/mass.h"
#include "solver/results/history.h"
#include "solver/results/run_source.h"
#include "solver/run/block_extremes.h"
#include "solver/run/bolt_extremes.h"
#include "solver/run/checkpoint.h"
#include "solver/run/checkpoint_check.h"
#include "solver/run/event_frames.h"
#include "solver/run/frame_forces.h"
#include "solver/run/run_limit.h"
#include "solver/run/stability.h"
#include "solver/run/stage_settings.h"
#include "solver/scene/collapse_stage.h"
#include "solver/scene/number_text.h"
#include "solver/scene/stage_objects.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

namespace keyblock {
namespace {

// iterations between checkpoints: a new pattern and a stored state cost as much as two or three
constexpr long fewestPasses = 200;
constexpr std::size_t stagesToEach = 64;  // finished stages per stage that may start without a checkpoint
constexpr long energyEvery = 8;  // dynamic steps between checks of the energy balance
constexpr long workBetween = 2000;  // iterations times bodies between the checkpoints of the smallest models

/// Initial state, with blocks and bolts at their positions in the scene.
Checkpoint startOf(const Scene& scene, const Model& model) {
    Checkpoint start;
    start.state = makeState(model);
    start.state.contacts = findContacts(model, start.state.blocks, {}, model.size * 1e-3, true);
    for (std::size_t b = 0; b < scene.bolts.size(); ++b)
        if (isInstalledLater(scene, scene.bolts[b])) leaveOut(model, start.state, static_cast<int>(b));
    placeBolts(model, start.state);
    preloadFaces(scene, model, start.state);
    start.state.startEnergy = accountedEnergy(model, start.state);
    start.extremes = startExtremes(model);
    start.blockExtremes.resize(model.blocks.size());
    start.eventFrames.shown.resize(model.bolts.size(), 0.0);
    return start;
}

class Runner : StepObserver {
public:
    Runner(const Scene& document, const Scene& scene, Sink& sink, Control& control)
        : document_(document), scene_(scene), sink_(sink), control_(control), limit_(scene.limits),
          model_(makeModel(scene)), now_(startOf(scene, model_)), engine_(model_), loads_(model_, scene, now_.loads),
          observation_(scene, model_, now_.state, now_.reference), watch_(model_, now_.state, now_.watch) {
        engine_.stopAsked = [this] { return stopAsked(); };
        engine_.passed = [this] { report(); };
    }

    std::vector<StageResult> run(const Checkpoint* from) {
        if (from) goOn(*from);
        else sink_.begin(document_, historyColumns(scene_));
        bool on = true;
        while (on && now_.stage < static_cast<int>(scene_.stages.size())) {
            stepping_ = false;
            show();
            if (now_.begun ? checkpointDue() : checkpointDueBetweenStages()) keepCheckpoint();
            StepEnding ending;
            atRest_ = true;
            const bool stop = stopAsked();
            atRest_ = false;
            if (stop) ending.ending = Ending::Stopped;
            else ending = now_.begun ? advance() : beginStage();
            if (ending.ending != Ending::Done || stageOver()) on = endStage(ending);
        }
        return now_.results;
    }

private:
    const Stage& stage() const { return scene_.stages[now_.stage]; }
    bool isStatic() const { return stage().kind == StageKind::Static; }
    double duration() const { return isStatic() ? 1.0 : stage().duration; }

    void goOn(const Checkpoint& from) {
        if (const auto misfit = misfitOf(from, model_, scene_)) refuse(*misfit);
        now_ = from;
        engine_.health = now_.health;
        model_.joints = jointModels(scene_, now_.begun ? now_.stage : now_.stage - 1);
        if (now_.begun) enterStage();
        if (now_.begun && stageOver()) refuse("increment");
        sink_.resume(document_, historyColumns(scene_), from);
    }

    [[noreturn]] static void refuse(const std::string& misfit) {
        throw UnfitCheckpoint("the checkpoint is damaged: it does not fit its scene (" + misfit +
                              "); run the scene again from the start");
    }

    bool checkpointDue() const {
        const long bodies = static_cast<long>(model_.blocks.size()) + model_.nodes;
        return engine_.health.passes - now_.passes >= std::max(fewestPasses, workBetween / std::max(1L, bodies));
    }

    /// A checkpoint contains the results of all previous stages, so after thousands of short stages not every stage can
    /// have one.
    bool checkpointDueBetweenStages() const {
        const std::size_t since = now_.results.size() - now_.resultsKept;
        return now_.results.empty() || since * stagesToEach >= now_.results.size() || checkpointDue();
    }

    void keepCheckpoint() {
        now_.resultsKept = now_.results.size();
        now_.health = engine_.health;
        now_.passes = engine_.health.passes;
        engine_.solver = {};
        part_.reset();
        sink_.checkpoint(now_);
    }

    /// Derives the data of a stage from the scene and the checkpoint.
    void enterStage() {
        times_ = isStatic() ? incrementTimes(scene_, stage(), loads_) : std::vector<double>{};
    }

    StepEnding beginStage() {
        sink_.stageBegins(now_.stage);
        now_.begun = true;
        now_.time = now_.frames.next = 0.0;
        now_.increment = 0;
        now_.within = {};
        now_.pace = {};
        now_.firstStep = now_.state.step;
        now_.passes -= engine_.health.passes;  // continues the count from the last checkpoint
        engine_.health = {};
        engine_.passedStep = -1;
        wakeAll(now_.state);
        part_.reset();
        setStrengths();
        const std::vector<WallForce> walls = changeActiveParts();
        loads_.begin(now_.stage, now_.state);
        if (isStatic() || stage().relaxation) loads_.hold(walls);
        setBoundaries();
        if (!stage().set.empty()) changeJoints(scene_, now_.stage, model_, now_.state);
        if (stage().zeroDisplacements) {
            observation_.zero(now_.state);
            forgetDisplacements(now_.blockExtremes);
        }
        watch_.beginStage(now_.state);
        now_.start = startOfStage(model_, now_.state);
        enterStage();
        const StepEnding ending = isStatic() ? standStill() : setMoving();
        markEnergy(model_, now_.state, now_.energy);
        keepFrame(false);
        return ending;
    }

    /// Removes bolts, excavates blocks and installs bolts.
    /// \return the forces of the excavated blocks on those that remain.
    std::vector<WallForce> changeActiveParts() {
        for (const std::string& name : stage().remove)
            for (int bolt : boltsNamed(scene_, name)) removeBolt(model_, now_.state, bolt);
        std::vector<int> rows;
        for (int block : excavatedBlocks(scene_, stage()))
            for (int row = model_.firstOf[block]; row < model_.firstOf[block + 1]; ++row)
                if (!now_.state.blocks[row].absent) rows.push_back(row);
        std::vector<WallForce> walls = excavate(model_, now_.state, rows);
        loads_.forgetAbsent(now_.state);
        for (const std::string& name : stage().install)
            for (int bolt : boltsNamed(scene_, name)) installBolt(model_, now_.state, bolt);
        return walls;
    }

    /// Makes the sides that this stage names non-reflecting, and no others.
    void setBoundaries() {
        restoreAllSupports(model_, now_.state);
        const std::vector<BoundarySide> sides = viscousSides(stage());
        if (!sides.empty()) loads_.quieten(dashpotsOn(model_, now_.state, sides), releaseSupports(model_, now_.state, sides));
        else loads_.quieten({}, {});
    }

    void setStrengths() {
        for (std::size_t b = 0; b < now_.state.bolts.size(); ++b)
            now_.state.bolts[b].strength = isStatic() ? StrengthFactors{} : model_.bolts[b].dynamicFactors;
    }

    StepEnding standStill() {
        now_.state.energy.damped += kineticEnergy(model_, now_.state);
        stopMotion(now_.state);
        return {};
    }

    StepEnding setMoving() {
        const double before = accountedEnergy(model_, now_.state);
        for (const InitialVelocity& initial : stage().initialVelocities)
            setVelocity(scene_, model_, initial, now_.state);
        const bool inMotion = !now_.results.empty() &&
                              scene_.stages[now_.results.back().stage].kind == StageKind::Dynamic;
        const StepEnding ending = dynamics().begin(now_.state, inMotion);
        // initial velocities and preload are given, not gained
        now_.state.startEnergy += accountedEnergy(model_, now_.state) - before;
        return ending;
    }

    /// Makes one accepted step or, in a static stage, one move within an increment.
    StepEnding advance() {
        if (!isStatic()) {
            return advanceInTime();
        }
        StaticSettings settings = staticSettings(scene_, stage());
        settings.motionFollows = increment() + 1 == times_.size() && motionFollows();
        const StepEnding ending = moveStatic(engine_, now_.state, loads_.loads(), loadsBefore(), loadsAfter(), settings,
                                             *this, now_.within);
        now_.time = between(loadsBefore(), loadsAfter(), now_.within.done).time;
        if (ending.ending == Ending::Done && !now_.within.releasing) noteExtremes(now_.state, now_.time);
        if (ending.ending != Ending::Done || now_.within.releasing) return ending;
        if (now_.within.over()) nextIncrement();
        else if (stage().increments || now_.increment == 0) {
            keepAfter();
            return ending;
        }
        lookAround();
        keepFrame(false);
        return ending;
    }

    /// Makes one dynamic step. Nothing is checked or recorded again while every block sleeps or nothing changes.
    StepEnding advanceInTime() {
        stepBegan_ = now_.time;
        const bool wasStill = engine_.passedStep == now_.state.step;
        const bool slept = wasStill || isAllAsleep(model_, now_.state);
        StepEnding ending = dynamics().step(now_.state, now_.time, stage().duration, now_.pace, *this);
        const bool isStill = engine_.passedStep == now_.state.step;
        if (ending.ending == Ending::Done && !(slept && isStill)) ending = checkEnergy(isStill);
        if (!(wasStill && isStill)) findAwake();
        engine_.health.awake += awake_;
        engine_.health.movable += awake_ + asleep_;
        mark(now_.start, now_.state, now_.time, stage().duration);
        if (!(slept && isStill)) lookBack(ending);
        keepFrame(false);
        return ending;
    }

    void findAwake() {
        awake_ = asleep_ = 0;
        for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
            const bool awake = isAwake(model_, now_.state, i);
            awake_ += awake;
            asleep_ += !awake && now_.state.blocks[i].rest.asleep;
        }
    }

    /// Records what a dynamic step has changed.
    void lookBack(const StepEnding& ending) {
        noteExtremes(now_.state, now_.time);
        if (ending.ending == Ending::Done) keepPassedPeak(now_.state);
        lookAround();
    }

    /// Lets the stage fail if the error of the energy balance exceeds the limit of the scene, since results with
    /// spurious energy are not valid. \param last if no check follows before blocks move again.
    StepEnding checkEnergy(bool last) {
        if (now_.state.step % energyEvery != 0 && !last && !stageOver()) return {};
        const auto excess = energyExcess(model_, now_.state, now_.start.blocks, scene_.limits.energy, now_.energy);
        if (!excess) return {};
        StepEnding failed{Ending::Failed,
                          "the energy balance error is " + rounded(100.0 * excess->share) + " %, more than " +
                              rounded(100.0 * scene_.limits.energy) + " % ('limits.energy')",
                          {}};
        if (excess->block >= 0) {
            failed.message +=
                "; the largest share is near block " + model_.blocks[excess->block].name;
            failed.blocks.push_back(excess->block);
        }
        failed.message += ": use a 'time_step' of " + rounded(0.5 * dynamicSettings(scene_, stage()).timeStep) +
                          " s or less";
        return failed;
    }

    /// True if a dynamic stage follows equilibrium in this stage.
    bool motionFollows() const {
        const auto next = std::find_if(scene_.stages.begin() + now_.stage + 1, scene_.stages.end(),
                                       [](const Stage& stage) { return !stage.followsCollapse; });
        return next != scene_.stages.end() && next->kind == StageKind::Dynamic;
    }

    /// Begins the next increment. Automatic lengths are kept until the load changes direction.
    void nextIncrement() {
        const std::vector<double> turns = loads_.turns();
        const double time = times_[increment()];
        const bool turned = now_.increment == 0 || std::any_of(turns.begin(), turns.end(), [&](double turn) {
            return std::abs(turn - time) < 1e-12;
        });
        IncrementProgress next;
        if (!turned) {
            next.chosen = now_.within.chosen;
            next.response = std::move(now_.within.response);
        }
        now_.within = std::move(next);
        ++now_.increment;
    }

    bool stageOver() const {
        return isStatic() ? now_.increment >= static_cast<int>(times_.size()) : now_.time >= stage().duration;
    }

    /// Loads at the start and the end of the increment.
    LoadPoint loadsBefore() const { return now_.increment == 0 ? loads_.start() : loads_.at(times_[increment() - 1]); }
    LoadPoint loadsAfter() const { return loads_.at(times_[increment()]); }
    std::size_t increment() const { return now_.increment; }

    LoadPoint loadsReached() const {
        if (!isStatic()) return loads_.at(now_.time);
        if (increment() == times_.size()) return loads_.at(times_.back());
        return between(loadsBefore(), loadsAfter(), now_.within.under);
    }

    SleepingStage dynamics() {
        return {engine_,
                part_,
                loads_.loads(),
                [this](double t) { return loads_.at(t); },
                dynamicSettings(scene_, stage()),
                sleepTolerance(scene_)};
    }

    /// \return true if the run continues with another stage.
    bool endStage(const StepEnding& ending) {
        if (!now_.begun) {  // stopped before the stage began
            sink_.stageBegins(now_.stage);
            now_.firstStep = now_.state.step;
            now_.time = 0.0;
            engine_.health = {};
            ended_ = loads_.start();
        } else {
            ended_ = loadsReached();
            loads_.end(*ended_);
        }
        if (ending.ending == Ending::Done && isStatic()) now_.time = 1.0;
        const StageResult result = resultOf(ending);
        ended_.reset();
        const std::optional<int> next = stageAfter(scene_, result);
        now_.results.push_back(result);
        sink_.stageEnds(result);
        now_.stage = next.value_or(now_.stage + 1);
        now_.begun = false;
        return next.has_value();
    }

    StageResult resultOf(const StepEnding& ending) {
        StageResult result;
        result.stage = now_.stage;
        result.time = now_.time;
        result.steps = now_.state.step - now_.firstStep;
        result.blocks = ending.blocks;
        result.message = ending.message;
        const Stability stability(model_, now_.start, now_.state, stage(), loads_.loads());
        switch (ending.ending) {
            case Ending::Done: done(result, stability); break;
            case Ending::NoEquilibrium: collapse(result, ending, stability); break;
            case Ending::Undecided: undecided(result); break;
            case Ending::Stopped: stopped(result); break;
            case Ending::Failed: result.outcome = Outcome::Failed; break;
        }
        keepFrame(true);
        if (now_.begun) {
            result.loose = stability.loose();
            result.farthest = stability.farthest();
        }
        result.health = engine_.health;
        result.health.balanceError = energyOf(model_, now_.state).balanceError;
        return result;
    }

    void stopped(StageResult& result) const {
        result.outcome = control_.stop ? Outcome::Stopped : Outcome::Limit;
        if (!control_.stop) result.message = limit_.message(now_.state.step);
    }

    /// Result of a stage that ended at rest in its original position, at rest elsewhere, or at the end of its time.
    void done(StageResult& result, const Stability& stability) const {
        result.outcome = isStatic() ? Outcome::Equilibrium : Outcome::Duration;
        if (!isStatic()) result.unstable = stability.moving(isContinued(result));
        else if (stage().until.move) result.unstable = stability.displaced(*stage().until.move);
        if (result.unstable.empty()) return;
        if (isStatic()) result.outcome = Outcome::Displaced;
        nameUnstable(result, isStatic() ? "blocks displaced before coming to rest:" : "blocks still moving or displaced at the end:");
    }

    /// True if a dynamic stage follows, in which blocks go on with their velocities.
    bool isContinued(const StageResult& result) const {
        const std::optional<int> next = stageAfter(scene_, result);
        return next && scene_.stages[*next].kind == StageKind::Dynamic;
    }

    void undecided(StageResult& result) const {
        result.outcome = Outcome::Undecided;
        result.message += "; raise 'limits.iterations' for a longer search";
    }

    void nameUnstable(StageResult& result, const std::string& what) const {
        result.message = what;
        result.blocks.clear();
        for (const UnstableBlock& one : result.unstable) {
            result.blocks.push_back(one.block);
            result.message += " " + model_.blocks[one.block].name;
        }
    }

    void collapse(StageResult& result, const StepEnding& ending, const Stability& stability) {
        result.outcome = Outcome::Collapse;
        result.unstable = stability.collapsed(ending.blocks, ending.followers);
        nameUnstable(result, "no equilibrium; moving blocks:");
        Event event;
        event.kind = EventKind::Collapse;
        event.cause = ending.cause;
        if (!result.blocks.empty()) {
            event.block = result.blocks.front();
            event.position = now_.state.blocks[event.block].centroid;
        }
        beforeEvent(now_.state, now_.time);
        this->event(event, now_.state, now_.time);
        afterEvent(now_.state, now_.time);
    }

    /// Reports events that need no release. They change nothing, so all have the history rows before and after them in
    /// common. The extremes of the state have already been recorded.
    void lookAround() {
        std::vector<Event> events = watch_.look(now_.state);
        if (events.empty()) return;
        writeRow(now_.state, now_.time);
        for (Event& event : events) this->event(event, now_.state, now_.time);
        writeRow(now_.state, now_.time);
    }

    void beforeEvent(const State& state, double time) override { keepRow(state, time); }
    void afterEvent(const State& state, double time) override { keepRow(state, time); }
    long event(Event event, const State& state, double time) override {
        if (callsForFrames(event)) keepBefore(event, state, time);
        event.stage = now_.stage;
        event.time = time;
        event.step = state.step;
        event.position += model_.origin;
        watch_.remember(event);
        sink_.event(event);
        return now_.written.events++;
    }

    void noteExtremes(const State& state, double time) {
        addExtremes(model_, state, now_.stage, time, now_.extremes);
        observation_.addExtremes(state, now_.stage, time, now_.blockExtremes);
    }

    void keepRow(const State& state, double time) {
        noteExtremes(state, time);
        writeRow(state, time);
    }

    void writeRow(const State& state, double time) {
        sink_.history(observation_.history(state, now_.stage, time));
        ++now_.written.historyRows;
    }

    /// Keeps the state before a bolt fails, unless a frame shortly before it shows equally large forces. In a dynamic
    /// stage, the largest force may have occurred before this state.
    void keepBefore(const Event& event, const State& state, double time) {
        EventFrames& frames = now_.eventFrames;
        frames.owed = true;
        if (isSeenAfterwards(event)) return;
        keepPassedPeak(state);
        const KeptAt now{now_.stage, time};
        const double interval = frameInterval(scene_, stage());
        const bool isKnown = isShortlyAfter(frames.before, now, interval) || isShortlyAfter(frames.after, now, interval);
        if (!isKnown || exceedsShown(model_, state, frames)) keepEventFrame(state, time, true);
        frames.before = now;
    }

    /// Keeps the state at the start of the last dynamic step if a bolt had its largest force so far there.
    void keepPassedPeak(const State& state) {
        if (isStatic() || stepBegan_ == now_.time || state.bolts.empty()) return;
        const TakenStep& whole = engine_.taken;
        if (whole.step == state.step && !passedPeak(model_, whole.before, state, now_.eventFrames)) return;
        const std::optional<State> before = stateBefore(engine_, part_.get(), state);
        if (before && passedPeak(model_, *before, state, now_.eventFrames)) keepEventFrame(*before, stepBegan_, false);
    }

    /// Keeps the state after bolts have failed, once no more fail at this load or shortly after.
    void keepAfter() {
        EventFrames& frames = now_.eventFrames;
        const KeptAt now{now_.stage, now_.time};
        if (!frames.owed || isShortlyAfter(frames.after, now, frameInterval(scene_, stage()))) return;
        frames.owed = false;
        frames.after = now;
        keepEventFrame(now_.state, now_.time, true);
    }

    void keepEventFrame(const State& state, double time, bool withForces) {
        EventFrames& frames = now_.eventFrames;
        if (!mayKeep(frames, plannedFrames(scene_, now_.stage)) && !isFarAboveShown(model_, state, frames)) return;
        writeFrame(state, time, withForces);
        ++frames.kept;
    }

    /// Keeps a frame if one is due. The last frame of a stage is always kept, but never the same state twice.
    void keepFrame(bool last) {
        FrameClock& clock = now_.frames;
        const bool due = last ? clock.keptStep != now_.state.step || clock.keptStage != now_.stage
                              : now_.time >= clock.next * (1.0 - 1e-12);
        if (!due) return last ? void() : keepAfter();
        const double every = frameInterval(scene_, stage());
        clock.next = (std::floor(now_.time * (1.0 + 1e-12) / every) + 1.0) * every;
        clock.keptStep = now_.state.step;
        clock.keptStage = now_.stage;
        keepRow(now_.state, now_.time);
        now_.eventFrames.owed = false;
        now_.eventFrames.after = {now_.stage, now_.time};
        writeFrame(now_.state, now_.time, true);
    }

    void writeFrame(const State& state, double time, bool withForces) {
        Frame frame = observation_.frame(state, now_.stage, time);
        frame.events = now_.written.events;
        if (withForces) frame.forces = frameForces(forcesIn(state), state, frame, !isStatic());
        frame.extremes = now_.extremes;
        frame.blockExtremes = now_.blockExtremes;
        noteShown(model_, state, now_.eventFrames);
        sink_.frame(frame);
        ++now_.written.frames;
    }

    /// In a dynamic stage, the forces over the last step, or those at the start if there has been no step.
    std::vector<SingleForce> forcesIn(const State& state) const {
        const LoadPoint at = ended_ ? *ended_ : loadsReached();
        if (isStatic()) return forcesAtRest(model_, state, loads_.loads(), at);
        const std::optional<TakenStep> step = now_.time > 0.0 ? lastStep(engine_, part_.get(), loads_.loads(), state)
                                                              : std::nullopt;
        if (step) return forcesOver(model_, loads_.loads(), *step);
        return forcesAtStart(model_, state, loads_.loads(), at, dynamicSettings(scene_, stage()).damping);
    }

    /// Waits between two steps while the run is paused, except for single steps that are requested. A step in progress
    /// is completed first, because there is no state to show in the middle of it.
    bool stopAsked() {
        if (atRest_ && control_.pause && !control_.stop && !stepping_) {
            const auto paused = std::chrono::steady_clock::now();
            waitForStep();
            limit_.addPause(std::chrono::steady_clock::now() - paused);
        }
        return control_.stop || limit_.reached(now_.state.step);
    }

    void waitForStep() {
        while (control_.pause && !control_.stop && !stepping_) {
            show();
            int left = control_.steps;
            stepping_ = left > 0 && control_.steps.compare_exchange_strong(left, left - 1);
            if (!stepping_) std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
    }

    /// Passes the state between two steps to the observer. The frame is not stored, and its single forces are not
    /// listed because no view shows them.
    void show() {
        if (!control_.looked || !now_.begun || !control_.look.exchange(false)) return;
        Frame frame = observation_.frame(now_.state, now_.stage, now_.time);
        frame.events = now_.written.events;
        frame.extremes = now_.extremes;
        frame.blockExtremes = now_.blockExtremes;
        control_.looked(frame);
    }

    void report() {
        if (!control_.progress) return;
        Progress progress;
        progress.stage = now_.stage;
        progress.time = now_.time;
        progress.fraction = (now_.stage + now_.time / duration()) / static_cast<double>(scene_.stages.size());
        progress.steps = now_.state.step;
        progress.passes = engine_.health.passes;
        progress.events = now_.written.events;
        progress.residual = engine_.health.maxResidual;
        progress.stepCuts = engine_.health.stepCuts + engine_.health.energyCuts;
        progress.step = engine_.newest;
        if (!isStatic()) progress.step.searched = 0;
        control_.progress(progress);
    }

    const Scene& document_;  // as given
    const Scene& scene_;  // as solved, after cutting
    Sink& sink_;
    Control& control_;
    RunLimit limit_;
    Model model_;  // constant, except for joint strengths that a stage changes
    Checkpoint now_;
    Engine engine_;
    std::unique_ptr<PartInUse> part_;  // what is awake, while something sleeps
    StageLoads loads_;
    Observation observation_;
    Watch watch_;
    std::vector<double> times_;  // end times of a static stage's increments
    std::optional<LoadPoint> ended_;  // loads at the end of a stage, while its result is being written
    double stepBegan_ = 0.0;  // start of the last dynamic step, in the time of the stage
    long awake_ = 0, asleep_ = 0;  // blocks after the last dynamic step
    bool stepping_ = false;  // a single step is made while paused
    bool atRest_ = false;  // between two steps
};

}  // namespace

std::vector<StageResult> run(const Scene& scene, Sink& sink, Control& control, const RunSettings& settings,
                             const Checkpoint* from) {
    const std::size_t threads = settings.threads > 0 ? static_cast<std::size_t>(settings.threads)
                                                     : std::max(1u, std::thread::hardware_concurrency());
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    std::optional<SceneCut> own;
    if (!settings.cut && needsCut(scene)) own = cutScene(scene);
    const SceneCut* cut = own ? &*own : settings.cut;
    const Scene solved = withCollapseStages(cut ? cut->scene : scene);
    return Runner(scene, solved, sink, control).run(from);
}

Results runInMemory(const Scene& scene, const RunSettings& settings) {
    MemorySink sink;
    Control control;
    run(scene, sink, control, settings);
    return std::move(sink.results);
}

}  // namespace keyblock
