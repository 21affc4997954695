// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/statics.h"

#include "solver/engine/bolt/plate.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/stage/limit_search.h"
#include "solver/engine/stage/limits.h"
#include "solver/engine/stage/resticks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double finestIncrement = 1e-3;  // of the given increment, before a collapse is believed
constexpr double followShare = 1e-9;  // of the scene: embedded lengths that changed less need no new equilibrium
constexpr int mostRounds = 6;
constexpr int mostTries = 60;  // to locate an event
constexpr double narrowest = 1e-12;  // of an increment, when one is
constexpr double locateShare = 1e-4;  // an event is located at least to this share of its limit

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
        return findEquilibrium(engine_, state, loads_, {reached(), between(a_, b_, to)}, settings_);
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
        return std::max(1.0, std::ceil(longest / longestMoveOf(engine_.model)));
    }

    void accept(State trial, double to) {
        reportResticks(engine_.model, ifSliding(state_), trial, reached().time, -1, observer_);
        progress_.passed.clear();
        progress_.lastRelease = -1;
        state_ = std::move(trial);
        ++state_.step;
        progress_.done = to;
    }

    /// What was found at its limit is released first: under new tributary lengths it may be under its limit again.
    /// But an anchored point is judged under its new length: it may have left the rock.
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

    /// The largest overload is released, alone; the next is judged at the equilibrium without it.
    StepEnding releaseOne() {
        const std::vector<Limit> limits = heldLimits(engine_.model, state_);
        const Limit released = worstLimit(limits, progress_.least).value();
        noteCauses(limits);
        progress_.least = 1.0 - tieShare;
        const double time = reached().time;
        progress_.lastRelease =
            releaseAndReport(engine_.model, state_, released, time, causeOf(released), observer_);
        if (!changesForces(engine_.model, released)) {
            observer_.afterEvent(state_, time);
            return followUnlessAtLimit();
        }
        const std::optional<State> sliding = ifSliding(state_);
        StepEnding ending = balanceAgain();
        ending.cause = progress_.lastRelease;
        if (ending.ending != Ending::Done) return ending;
        observer_.afterEvent(state_, time);
        reportResticks(engine_.model, sliding, state_, time, progress_.lastRelease, observer_);
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
