// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/statics.h"

#include "solver/engine/bolt/plate.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/contact_limits.h"
#include "solver/engine/stage/limit_search.h"
#include "solver/engine/stage/limits.h"
#include "solver/engine/stage/path_review.h"
#include "solver/engine/stage/resticks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double finestIncrement = 1e-3;  // of the given increment, before a collapse is believed
constexpr double followShare = 1e-9;  // of the scene: embedded lengths that changed less need no new equilibrium
constexpr int mostRounds = 6;
constexpr int mostTries = 60;  // to locate an event
constexpr double narrowest = 1e-12;  // of an increment, when one is
constexpr int mostStalled = 3;  // of these that come no nearer
constexpr long longSearch = 40;  // iterations of a try, after which the next begins where it ended
constexpr double locateShare = 1e-4;  // an event is located at least to this share of its limit

// Of increments that the program chooses, in pseudo-time.
constexpr double longestBent = 0.1;  // in which joints slide, open or close: as many points draw their curves
constexpr double longestFlow = 0.02;  // in which bolts flow
constexpr double shortestChosen = 2.5e-3;  // whatever happens on the way, but that there is no equilibrium
constexpr double finestCollapse = 0.02;  // before a collapse is believed
constexpr long fewPasses = 16;  // that show whether nothing slides over a long increment
constexpr long mostInSearch = 400;  // pseudo-steps, after which a shorter increment is tried

/// One move within an increment.
class Move {
public:
    Move(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
         const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress)
        : engine_(engine), state_(state), loads_(loads), a_(a), b_(b), settings_(settings), observer_(observer),
          progress_(progress) {}

    StepEnding make() {
        StepEnding ending = progress_.releasing ? releaseOne() : isChosen() ? loadByChoice() : loadOn();
        if (ending.ending != Ending::Done) return ending;
        progress_.releasing = limit().has_value();
        if (!progress_.releasing) lockOffPlates(engine_.model, state_);
        return ending;
    }

private:
    /// An equilibrium farther along the path of the load.
    struct Reached {
        State state;
        double share = 0.0;
        bool atLimit = false;  // the first limit was located here
    };

    /// \param most pseudo-steps, after which the search ends as `Undecided`; never more than are left altogether.
    StepEnding equilibrium(State& state, double to, long most = std::numeric_limits<long>::max(),
                           bool followsFalls = true) {
        return equilibrium(state, {reached(), between(a_, b_, to)}, most, followsFalls);
    }

    StepEnding equilibrium(State& state, const LoadPath& path, long most = std::numeric_limits<long>::max(),
                           bool followsFalls = true) {
        StaticSettings settings = settings_;
        settings.followsFalls = followsFalls;
        settings.maxSteps = std::min(most, settings_.maxSteps - progress_.solves);
        const long before = engine_.health.steps;
        StepEnding ending = findEquilibrium(engine_, state, loads_, path, settings);
        progress_.solves += engine_.health.steps - before;
        if (ending.ending == Ending::Undecided && isWorkedOut())
            ending.message = "no verdict after " + std::to_string(progress_.solves) + " pseudo-steps: " + ending.message;
        return ending;
    }

    /// A search as long as there may be one, in parts: where one has come to no verdict, what has passed its limit on the
    /// way may let go first.
    StepEnding searchOn(State& state, double to) {
        for (;;) {
            const StepEnding ending = equilibrium(state, to, mostInSearch);
            if (ending.ending != Ending::Undecided || ending.final || isWorkedOut() || lettingGo(ending, state)) return ending;
        }
    }

    /// Goes on with what was seen falling under this load.
    StepEnding followFall(State& state, double to) {
        const LoadPoint at = between(a_, b_, to);
        return equilibrium(state, {at, at}, std::numeric_limits<long>::max(), true);
    }

    bool passesLimit(const State& state) const {
        return worstLimit(heldLimits(engine_.model, state), 1.0 + reachedShare).has_value();
    }

    bool passesBoltLimit(const State& state) const {
        std::vector<Limit> limits = heldLimits(engine_.model, state);
        std::erase_if(limits, [](const Limit& limit) { return ofJoint(limit.kind); });
        return worstLimit(limits, 1.0 + reachedShare).has_value();
    }

    /// True where a search ended among moving blocks and bolts have passed their limits on the way: these let go before
    /// anything is reported.
    bool lettingGo(const StepEnding& ending, const State& state) const {
        if (ending.ending == Ending::Undecided) return !ending.final && !isWorkedOut() && passesLimit(state);
        return ending.ending == Ending::NoEquilibrium && passesBoltLimit(state);
    }

    /// Ends where the moving blocks had got to.
    void leaveMoving(Reached moving) {
        state_ = std::move(moving.state);
        progress_.under = moving.share;
    }

    /// Goes on from a moving state as from one at rest, but with releases first.
    StepEnding takeMoving(Reached moving) {
        accept(std::move(moving));
        progress_.moving = true;
        return {};
    }

    /// As much work is done since the last event or accepted increment as may be.
    bool isWorkedOut() const { return progress_.solves >= settings_.maxSteps; }

    static bool isMoving(const StepEnding& ending) {
        return ending.ending == Ending::NoEquilibrium || ending.ending == Ending::Undecided;
    }

    bool isChosen() const { return settings_.chosen && span() > 0.0; }

    /// In pseudo-time.
    double span() const { return b_.time - a_.time; }

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
            const bool less = step > finestIncrement * whole && !isSameLoad(a_, b_);
            StepEnding ending = equilibrium(trial, to, less ? mostInSearch : std::numeric_limits<long>::max(), !less);
            if (isMoving(ending) && less && !isWorkedOut()) {
                if (to < 1.0 || standsAtFirst(whole)) {
                    step *= 0.5;
                    continue;
                }
                if (ending.ending == Ending::NoEquilibrium) ending = followFall(trial, to);
            }
            if (lettingGo(ending, trial)) return takeMoving({std::move(trial), to});
            if (ending.ending != Ending::Done) {
                if (isMoving(ending)) leaveMoving({std::move(trial), to});
                return ending;
            }
            Reached next{std::move(trial), to};
            ending = toFirstLimit(next);
            if (ending.ending != Ending::Done) return ending;
            accept(std::move(next));
            return followUnlessAtLimit();
        }
    }

    /// On as far as what happens on the way allows, and at most to the first limit.
    StepEnding loadByChoice() {
        for (;;) {
            const double to = nextShare();
            const double length = (to - progress_.done) * span();
            Reached next{state_, to};
            StepEnding ending = equilibriumWithin(next.state, to, patienceFor(length));
            const bool found = ending.ending == Ending::Done;
            if (found) ending = toFirstLimit(next);
            if (!isWorkedOut() && (isTooDear(ending, length) || (isMoving(ending) && isTooFar(length)))) {
                if (isMoving(ending)) progress_.fails = to;
                shorten(length, ending.ending);
                continue;
            }
            if (!found && lettingGo(ending, next.state)) return takeMoving(std::move(next));
            if (ending.ending != Ending::Done) {
                if (isMoving(ending) && !found) leaveMoving(std::move(next));
                return ending;
            }
            if (!take(std::move(next))) continue;
            return followUnlessAtLimit();
        }
    }

    /// Equal parts of what is left, none longer than is tried next, and not yet so far as one that failed.
    double nextShare() const {
        const double left = (1.0 - progress_.done) * span();
        const double longest = std::min(progress_.chosen.next, span() / piecesOfMotion());
        const double parts = std::ceil(left / longest * (1.0 - 1e-9));
        const double next = parts <= 1.0 ? 1.0 : progress_.done + (1.0 - progress_.done) / parts;
        return progress_.fails > progress_.done ? std::min(next, nearerTo(progress_.fails)) : next;
    }

    /// Half of the way to where no equilibrium was found, or all of it where it is short enough to believe that.
    double nearerTo(double fails) const {
        const double way = fails - progress_.done;
        return isTooFar(way * span()) ? progress_.done + 0.5 * way : fails;
    }

    /// Accepts what was reached, unless too much happened on the way: then a shorter increment is next.
    bool take(Reached next) {
        ChosenLength& chosen = progress_.chosen;
        const double length = (next.share - progress_.done) * span();
        const PathReview review =
            reviewPath(engine_.model, state_, next.state, chosen.last > 0.0 ? length / chosen.last : 0.0);
        const double longest = review.straight ? 1.0 : review.boltsFlow ? longestFlow : longestBent;
        const bool tooLong = length > longest * (1.0 + 1e-9) || review.error > 1.0;
        if (tooLong && length > shortestChosen * (1.0 + 1e-9)) {
            chosen.next = std::max(shortestChosen, std::min(longest, review.error > 1.0 ? 0.5 * length : length));
            return false;
        }
        if (chosen.grows && 4.0 * review.error <= 1.0) chosen.next = std::max(chosen.next, 2.0 * length);
        chosen.next = std::min(chosen.next, longest);
        chosen.last = length;
        accept(std::move(next));
        return true;
    }

    /// Passes after which a shorter increment is tried first.
    static long patienceFor(double length) {
        return isLong(length) ? fewPasses : std::numeric_limits<long>::max();
    }

    /// The search for equilibrium ends as `Stopped` once it has taken more passes than it may.
    StepEnding equilibriumWithin(State& state, double to, long passes) {
        left_ = passes;
        const std::function<bool()> asked = engine_.stopAsked;
        engine_.stopAsked = [this, &asked] { return left_-- <= 0 || (asked && asked()); };
        constexpr long any = std::numeric_limits<long>::max();
        const bool mayBeShorter = isTooFar((to - progress_.done) * span());
        StepEnding ending = equilibrium(state, to, mayBeShorter ? mostInSearch : any, !mayBeShorter);
        engine_.stopAsked = asked;
        return ending;
    }

    /// True where the search was given up, or did not settle, and a shorter increment may do better.
    bool isTooDear(const StepEnding& ending, double length) const {
        if (length <= shortestChosen * (1.0 + 1e-9)) return false;
        return ending.ending == Ending::Failed || (ending.ending == Ending::Stopped && left_ < 0);
    }

    /// Longer than those in which something happens.
    static bool isLong(double length) { return length > longestBent * (1.0 + 1e-9); }

    /// True where there may be an equilibrium nearer than so far away.
    bool isTooFar(double length) const { return length > finestCollapse * (1.0 + 1e-9) && !isSameLoad(a_, b_); }

    /// Increments do not grow any more once one of usual length was too long.
    void shorten(double length, Ending ending) {
        ChosenLength& chosen = progress_.chosen;
        const bool probed = ending != Ending::NoEquilibrium && isLong(length);
        chosen.next = isLong(length) ? longestBent : 0.5 * length;
        if (ending != Ending::NoEquilibrium) chosen.next = std::max(shortestChosen, chosen.next);
        chosen.grows = chosen.grows && probed;
    }

    /// Where there is no equilibrium at the end of a load that has not begun yet: is there one under next to nothing
    /// of it? What slides under that slides under any share of it.
    bool standsAtFirst(double whole) {
        if (progress_.done > 0.0) return true;
        State trial = state_;
        return equilibrium(trial, finestIncrement * whole, mostInSearch, false).ending != Ending::NoEquilibrium;
    }

    /// Prescribed moves and dilations longer than a pseudo-step may be are taken in pieces.
    double piecesOfMotion() const {
        return std::max(1.0, std::ceil(longestDrive(a_, b_) / longestMoveOf(engine_.model)));
    }

    void accept(Reached next) {
        reportResticks(engine_.model, ifSliding(state_), next.state, reached().time, -1, observer_);
        progress_.least = next.atLimit ? 1.0 - locateShare : 1.0 + reachedShare;
        progress_.passed.clear();
        progress_.lastRelease = -1;
        progress_.solves = 0;
        state_ = std::move(next.state);
        ++state_.step;
        progress_.done = progress_.under = next.share;
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

    /// Cuts the increment where the first limit is reached, if one is passed.
    StepEnding toFirstLimit(Reached& over) {
        std::vector<Limit> atEnd = heldLimits(engine_.model, over.state);
        if (!worstLimit(atEnd, 1.0 + reachedShare)) return {};
        over.atLimit = true;
        LimitSearch search(progress_.done, heldLimits(engine_.model, state_), over.share, std::move(atEnd));
        Reached under{state_, progress_.done};  // where the tries begin
        double nearest = std::numeric_limits<double>::max();  // to the limit, over it
        int stalled = 0;  // tries since that was halved: equilibria are not exact enough for more
        for (int tries = 0;; ++tries) {
            const double middle = search.next();
            State trial = under.state;
            const long before = engine_.health.passes;
            const StepEnding ending = equilibrium(trial, {between(a_, b_, under.share), between(a_, b_, middle)});
            if (ending.ending != Ending::Done) return ending;
            std::vector<Limit> limits = heldLimits(engine_.model, trial);
            const auto worst = worstLimit(limits, 0.0);
            const double off = worst ? worst->ratio - 1.0 : -1.0;
            const bool exact = std::abs(off) <= reachedShare;
            stalled = std::abs(off) < 0.5 * nearest ? 0 : stalled + 1;
            nearest = std::min(nearest, std::abs(off));
            const bool goodEnough = std::abs(off) <= locateShare && stalled >= mostStalled;
            if (exact || goodEnough) {
                over.state = std::move(trial);
                over.share = middle;
                return {};
            }
            if (off > 0.0) over.state = std::move(trial);
            else if (engine_.health.passes - before > longSearch) under = {std::move(trial), middle};
            search.take(middle, std::move(limits), off > 0.0);
            over.share = search.high();
            if (tries > mostTries || search.width() <= narrowest) return {};  // the limit is passed in a jump
        }
    }

    /// The largest overload is released, alone; the next is judged at the equilibrium without it.
    StepEnding releaseOne() {
        const std::vector<Limit> limits = heldLimits(engine_.model, state_);
        const Limit released = worstLimit(limits, progress_.least).value();
        noteCauses(limits);
        progress_.least = 1.0 - tieShare;
        progress_.solves = 0;
        progress_.chosen.last = 0.0;
        const double time = reached().time;
        progress_.lastRelease =
            releaseAndReport(engine_.model, state_, released, time, causeOf(released), observer_);
        if (!changesForces(engine_.model, released) && (!progress_.moving || limit())) {
            observer_.afterEvent(state_, time);
            return progress_.moving ? StepEnding{} : followUnlessAtLimit();
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
        const StepEnding ending = searchOn(trial, progress_.done);
        state_ = std::move(trial);
        progress_.moving = lettingGo(ending, state_);
        if (progress_.moving) return {};  // what passed its limit is released next
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
    long left_ = 0;  // passes of a search that may be given up
};

}  // namespace

StepEnding moveStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                      const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress) {
    return Move(engine, state, loads, a, b, settings, observer, progress).make();
}

}  // namespace keyblock
