// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pseudo-step solves the step's minimisation from rest, with 2M/Δt² as a
// regularisation; bodies move, geometry is taken afresh, and equilibrium is
// judged on the true forces there, without that term. Laws are judged from the
// state in which the increment began and accepted only at equilibrium, so the
// path of the pseudo-steps leaves no trace.
#include "solver/engine/stage/statics.h"

#include "solver/engine/bolt/pretension.h"
#include "solver/engine/bolt/resticks.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/contacts.h"
#include "solver/engine/contact/multipliers.h"
#include "solver/engine/stage/energy_account.h"
#include "solver/engine/stage/limit_search.h"
#include "solver/engine/step/friction_limits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double softestInertia = 1e-11;  // regularisation over the stiffest spring
constexpr double moveShare = 0.05;  // of the smallest block: the longest move of one pseudo-step
constexpr double farShare = 2.0;  // of a block's own size: moved so far it has left its place
constexpr double shortestStep = 1e-7;  // over the longest pseudo-step
constexpr double finestIncrement = 1e-3;  // of the given increment, before a collapse is believed
constexpr double followShare = 1e-9;  // of the scene: embedded lengths that changed less need no new equilibrium
constexpr double wellBalanced = 1e-9;  // residual over the reference force that needs no better
constexpr double stillFalling = 0.1;  // of the residual before: so quick a fall is followed under the tolerance, too
constexpr double pathShare = 1e-4;  // of the longest move: a longer one may come in by another edge than it seemed
constexpr int mostPaths = 2;  // times that a pseudo-step is done again because it does
constexpr double swingCut = 0.3;  // of a pseudo-step, where steps go to and fro
constexpr double fadingSwing = 0.7;  // of the step before: such a swing dies out by itself
constexpr double noSwing = 1e3;  // over round-off: shorter moves are noise
constexpr double lostShare = 30.0;  // of the longest move: a body that flies so far while a step is solved is let go
constexpr int morePasses = 5;  // times those of a step in motion: shorter pseudo-steps settle friction no sooner
constexpr int mostRounds = 6;
constexpr int lockedSteps = 2;  // pseudo-steps with friction locked, when joints take up the run's first forces
constexpr int mostTries = 60;  // to locate an event
constexpr double narrowest = 1e-12;  // of an increment, when one is
constexpr double locateShare = 1e-4;  // an event is located at least to this share of its limit

double longestPseudoStep(const Model& model) {
    double mass = 0.0;
    for (const BlockModel& block : model.blocks) mass += block.mass;
    mass /= static_cast<double>(model.blocks.size());
    return mass > 0.0 ? std::sqrt(2.0 * mass / (softestInertia * model.stiffest)) : 1.0;
}

/// One search for equilibrium under fixed loads.
class Equilibrium {
public:
    Equilibrium(Engine& engine, const Loads& loads, const StaticSettings& settings)
        : engine_(engine), model_(engine.model), loads_(loads), settings_(settings),
          tolerance_(std::min(settings.unbalanced, engine.model.analysis.tolerance)),
          moveLimit_(moveShare * smallestSize(engine.model)), longest_(longestPseudoStep(engine.model)),
          dt_(longest_) {}

    StepEnding find(State& state, const LoadPoint& before, const LoadPoint& at) {
        const StaticBooks books(model_, state, loads_, before);
        const std::vector<BlockMotion> places = state.blocks;
        Eigen::VectorXd moved =
            Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model_.blocks.size()) + 3 * model_.nodes);
        Ending ending = Ending::NoEquilibrium;
        std::string message;
        int worst = -1;
        Eigen::VectorXd path;
        int paths = 0, taken = 0;
        for (int step = 0; step < settings_.maxSteps; ++step) {
            const Eigen::VectorXd* known = paths > 0 ? &path : nullptr;
            state.contacts = findContacts(model_, state.blocks, state.contacts,
                                          {searchMargin(state), false, true, known, &state.energy.released});
            meetDilated(state, state.contacts);
            const bool lock = taken < lockedSteps && state.step == 0 && unloaded(state);
            StepProblem problem = buildStep(model_, state, loads_, at, {Inertia::Static, dt_, lock});
            if (!lock && balanced(state, problem, step)) {
                Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
                books.book(state, at, moved, problem);
                acceptStep(model_, state, problem, still);
                countAccepted(engine_, state, residual_);
                return {};
            }
            Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
            const StepNeeds needs{tolerance_, morePasses, lostShare * moveLimit_, false};
            const SolveReport report = solveStep(engine_, problem, state, d, needs);
            if (report.stopped) return {Ending::Stopped, "", {}};
            worst = report.worst;
            const double move = report.converged || report.lost ? largestMove(model_, problem, d) : 0.0;
            if (!report.converged || move > moveLimit_) {
                ++engine_.health.stepCuts;
                dt_ *= move > moveLimit_ ? std::clamp(0.9 * std::sqrt(moveLimit_ / move), 0.01, 0.9) : 0.3;
                if (dt_ >= shortestStep * longest_) continue;
                ending = Ending::Failed;
                message = report.singular ? nameOfBody(model_, worst) + " is held by nothing"
                                          : "no step settles near " + nameOfBody(model_, worst);
                break;
            }
            if (paths < mostPaths && move > pathShare * moveLimit_ &&
                !entrancesHold(model_, state.blocks, state.contacts, searchMargin(state), d)) {
                path = d;
                ++paths;
                continue;
            }
            paths = 0;
            ++taken;
            moveBodies(model_, state, d);
            moved += d;
            if (!lock) lastMove_ = move;
            drifts_ = lastStep_.size() > 0 && d.dot(lastStep_) > 0.5 * d.norm() * lastStep_.norm();
            dt_ = swings(d, move) ? swingCut * dt_ : longer(move);
            lastStep_ = d;
            if (!farBlocks(places, state).empty()) break;
        }
        if (ending == Ending::NoEquilibrium) acceptMoving(state, at, moved, books);
        StepEnding result{ending, message, farBlocks(places, state)};
        if (!result.blocks.empty()) return result;
        const int named = ending == Ending::Failed ? blockOfBody(model_, worst) : mostMoved(places, state);
        if (named >= 0) result.blocks.push_back(named);
        return result;
    }

private:
    /// How far the search for contacts reaches [m].
    double searchMargin(const State& state) const { return 2.0 * moveLimit_ + widestOpening(state); }

    /// Takes over where the moving blocks had got to: history and energy of their way, whatever does not balance.
    void acceptMoving(State& state, const LoadPoint& at, const Eigen::VectorXd& moved, const StaticBooks& books) {
        state.contacts =
            findContacts(model_, state.blocks, state.contacts,
                         {searchMargin(state), false, true, nullptr, &state.energy.released});
        meetDilated(state, state.contacts);
        StepProblem problem = buildStep(model_, state, loads_, at, {Inertia::Static, dt_, false});
        books.book(state, at, moved, problem);
        acceptStep(model_, state, problem, Eigen::VectorXd::Zero(problem.unknowns()));
        ++state.step;  // not the state before: it has a frame of its own
    }

    /// No joint has carried anything yet: friction without normal forces would let everything slide.
    static bool unloaded(const State& state) {
        return std::all_of(state.contacts.begin(), state.contacts.end(),
                           [](const Contact& c) { return c.normalForce == 0.0 && !c.bonded; });
    }

    bool balanced(const State& state, StepProblem& problem, int step) {
        for (int i = 0; i < problem.unknowns(); ++i)
            if (problem.known[static_cast<std::size_t>(i)] && std::abs(problem.value[i]) > roundOff()) return false;
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
        correctFrictionLimits(problem, still);
        const Eigen::VectorXd net = netForce(problem, still);
        const double reference = referenceForce(problem, still, net);
        const double before = std::exchange(residual_, residualNorm(problem, net) / reference);
        if (usesMultipliers(model_) && multiplierError(model_, state, problem, still) > 1.0) return false;
        if (residual_ > settings_.unbalanced) return step > 0 && dt_ >= longest_ && isNoise(problem, net, before);
        return residual_ <= wellBalanced || residual_ > stillFalling * before;  // no longer worth a pseudo-step
    }

    /// What is left is what round-off in the places raises: it falls no more, and nothing drifts.
    bool isNoise(const StepProblem& problem, const Eigen::VectorXd& net, double before) const {
        if (lastMove_ <= roundOff()) return true;
        const bool stalls = residual_ > 0.9 * before;
        return stalls && !drifts_ && residualNorm(problem, net) <= placeNoise(problem, 0.25 * roundOff());
    }

    /// The next pseudo-step: twice as long, but not so long that what falls freely would go too far in it.
    double longer(double move) const {
        const double room = move > 0.0 ? std::sqrt(0.9 * moveLimit_ / move) : 2.0;
        return std::min(std::clamp(room, 1.0, 2.0) * dt_, longest_);
    }

    /// Steps to and fro that do not get shorter: what turns with the bodies is stiffer or softer than a step can see.
    bool swings(const Eigen::VectorXd& d, double move) const {
        if (lastStep_.size() == 0 || move < noSwing * roundOff()) return false;
        const double before = lastStep_.norm();
        return d.norm() > fadingSwing * before && d.dot(lastStep_) < -0.5 * d.norm() * before;
    }

    /// Moves smaller than this are lost in the coordinates [m].
    double roundOff() const { return 4.0 * std::numeric_limits<double>::epsilon() * model_.size; }

    std::vector<int> farBlocks(const std::vector<BlockMotion>& places, const State& state) const {
        std::vector<int> far;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const bool driven = std::any_of(loads_.motions.begin(), loads_.motions.end(),
                                            [&](const PrescribedMotion& m) { return m.block == static_cast<int>(i); });
            const double moved = (state.blocks[i].centroid - places[i].centroid).norm();
            if (!driven && moved > farShare * model_.blocks[i].size) far.push_back(static_cast<int>(i));
        }
        return far;
    }

    /// Where nothing has left its place yet: the block that is farthest on its way, over its own size.
    int mostMoved(const std::vector<BlockMotion>& places, const State& state) const {
        int most = -1;
        double farthest = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double moved = (state.blocks[i].centroid - places[i].centroid).norm() / model_.blocks[i].size;
            if (moved <= farthest) continue;
            farthest = moved;
            most = static_cast<int>(i);
        }
        return most;
    }

    Engine& engine_;
    const Model& model_;
    const Loads& loads_;
    const StaticSettings& settings_;
    double tolerance_;
    double moveLimit_;
    double longest_, dt_;
    double lastMove_ = std::numeric_limits<double>::max();
    Eigen::VectorXd lastStep_;
    bool drifts_ = false;  // the last two steps went the same way
    double residual_ = std::numeric_limits<double>::max();  // over the reference force, when last judged
};

/// One move within an increment.
class Move {
public:
    Move(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
         const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress)
        : engine_(engine), state_(state), loads_(loads), a_(a), b_(b), settings_(settings), observer_(observer),
          progress_(progress) {}

    StepEnding make() {
        StepEnding ending = progress_.releasing ? releaseOne() : loadOn();
        if (ending.ending != Ending::Done) return ending;
        progress_.releasing = limit().has_value();
        if (!progress_.releasing) lockOffPlates(engine_.model, state_);
        return ending;
    }

private:
    StepEnding equilibrium(State& state, double to) {
        return Equilibrium(engine_, loads_, settings_).find(state, reached(), between(a_, b_, to));
    }

    LoadPoint reached() const { return between(a_, b_, progress_.done); }

    std::optional<Limit> limit() const { return worstLimit(heldLimits(engine_.model, state_), progress_.least); }

    /// On by the step, or by less where no equilibrium is found so far away, and at most to the first limit.
    StepEnding loadOn() {
        const double whole = 1.0 / piecesOfMotion();
        double& step = progress_.step;
        if (step == 0.0) step = whole;
        for (;;) {
            const double to = progress_.done + step >= 1.0 - 1e-12 ? 1.0 : progress_.done + step;
            State trial = state_;
            StepEnding ending = equilibrium(trial, to);
            const bool less = step > finestIncrement * whole && !isSameLoad(a_, b_);
            if (ending.ending == Ending::NoEquilibrium && less && (to < 1.0 || standsAtFirst(whole))) {
                step *= 0.5;
                continue;
            }
            if (ending.ending != Ending::Done) {
                if (ending.ending == Ending::NoEquilibrium) state_ = std::move(trial);
                return ending;
            }
            progress_.least = 1.0 + reachedShare;
            if (!worstLimit(heldLimits(engine_.model, trial), progress_.least)) {
                accept(std::move(trial), to);
            } else {
                ending = toFirstLimit(std::move(trial), to);
                progress_.least = 1.0 - locateShare;  // the one that was located
            }
            return ending.ending == Ending::Done ? followUnlessAtLimit() : ending;
        }
    }

    /// Where there is no equilibrium at the end of a load that has not begun yet: is there one under next to nothing
    /// of it? What slides under that slides under any share of it.
    bool standsAtFirst(double whole) {
        if (progress_.done > 0.0) return true;
        State trial = state_;
        return equilibrium(trial, finestIncrement * whole).ending != Ending::NoEquilibrium;
    }

    /// Prescribed moves longer than a pseudo-step may be are taken in pieces.
    double piecesOfMotion() const {
        double longest = 0.0;
        for (std::size_t i = 0; i < b_.motions.size(); ++i)
            longest = std::max(longest, std::abs(b_.motions[i] - a_.motions[i]));
        return std::max(1.0, std::ceil(longest / (moveShare * smallestSize(engine_.model))));
    }

    void accept(State trial, double to) {
        tellResticks(engine_.model, ifSliding(state_), trial, reached().time, -1, observer_);
        progress_.passed.clear();
        progress_.lastRelease = -1;
        state_ = std::move(trial);
        ++state_.step;
        progress_.done = to;
    }

    /// What was found at its limit lets go first: under the shares that nodes have then it may be under it again.
    /// But an anchored point is judged under its new share: it may have left the rock.
    StepEnding followUnlessAtLimit() {
        const std::optional<Limit> next = limit();
        const bool first = next && next->kind != LimitKind::Bond && next->kind != LimitKind::CurveEnd;
        return first ? StepEnding{} : follow();
    }

    /// Gives nodes the blocks and shares they have now, and finds the equilibrium that goes with them.
    StepEnding follow() {
        const double small = followShare * engine_.model.size;
        for (int round = 0; round < mostRounds && followBolts(engine_.model, state_) > small; ++round) {
            State trial = state_;
            const StepEnding ending = equilibrium(trial, progress_.done);
            state_ = std::move(trial);
            if (ending.ending != Ending::Done) return ending;
        }
        return {};
    }

    /// Cuts the increment where the first limit is reached: `over` is the state at `to`, past it.
    StepEnding toFirstLimit(State over, double to) {
        LimitSearch search(progress_.done, heldLimits(engine_.model, state_), to, heldLimits(engine_.model, over));
        for (int tries = 0;; ++tries) {
            const double middle = search.next();
            State trial = state_;
            const StepEnding ending = equilibrium(trial, middle);
            if (ending.ending != Ending::Done) return ending;
            std::vector<Limit> limits = heldLimits(engine_.model, trial);
            const auto worst = worstLimit(limits, 0.0);
            const double off = worst ? worst->ratio - 1.0 : -1.0;
            const bool exact = std::abs(off) <= reachedShare;
            const bool goodEnough = std::abs(off) <= locateShare && tries > 12;
            if (exact || goodEnough) {
                accept(std::move(trial), middle);
                return {};
            }
            if (off > 0.0) over = std::move(trial);
            search.take(middle, std::move(limits), off > 0.0);
            if (tries > mostTries || search.width() <= narrowest) {  // the limit is passed in a jump
                accept(std::move(over), search.high());
                return {};
            }
        }
    }

    /// The largest overload lets go, alone; the next is judged at the equilibrium without it.
    StepEnding releaseOne() {
        const std::vector<Limit> limits = heldLimits(engine_.model, state_);
        const Limit released = worstLimit(limits, progress_.least).value();
        noteCauses(limits);
        progress_.least = 1.0 - tieShare;
        const double time = reached().time;
        progress_.lastRelease =
            releaseAndTell(engine_.model, state_, released, time, causeOf(released), observer_);
        if (!changesForces(engine_.model, released)) {
            observer_.afterEvent(state_, time);
            return followUnlessAtLimit();
        }
        const std::optional<State> sliding = ifSliding(state_);
        StepEnding ending = balanceAgain();
        ending.cause = progress_.lastRelease;
        if (ending.ending != Ending::Done) return ending;
        observer_.afterEvent(state_, time);
        tellResticks(engine_.model, sliding, state_, time, progress_.lastRelease, observer_);
        return ending;
    }

    /// Equilibrium after a release, at the same load.
    StepEnding balanceAgain() {
        State trial = state_;
        const StepEnding ending = equilibrium(trial, progress_.done);
        state_ = std::move(trial);
        if (ending.ending != Ending::Done) return ending;
        ++state_.step;
        return follow();
    }

    /// What is over its limit now and was not before was set over by the last release; with none yet, by the load.
    void noteCauses(const std::vector<Limit>& limits) {
        std::vector<PassedLimit> passed;
        for (const Limit& limit : limits)
            if (limit.ratio >= 1.0 - tieShare) passed.push_back({limit, causeOf(limit)});
        progress_.passed = std::move(passed);
    }

    long causeOf(const Limit& limit) const {
        const auto same = std::find_if(progress_.passed.begin(), progress_.passed.end(),
                                       [&](const PassedLimit& p) { return sameLimit(p.limit, limit); });
        return same == progress_.passed.end() ? progress_.lastRelease : same->cause;
    }

    Engine& engine_;
    State& state_;
    const Loads& loads_;
    const LoadPoint& a_;
    const LoadPoint& b_;
    const StaticSettings& settings_;
    StepObserver& observer_;
    IncrementProgress& progress_;
};

}  // namespace

StepEnding moveStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                      const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress) {
    return Move(engine, state, loads, a, b, settings, observer, progress).make();
}

}  // namespace keyblock
