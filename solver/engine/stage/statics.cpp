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

constexpr double finestIncrement = 1e-3;  // fraction of the given increment from which a collapse is accepted
// fraction of the model size: smaller changes of embedded lengths need no new equilibrium
constexpr double followShare = 1e-9;
constexpr int mostRounds = 6;
constexpr int mostTries = 60;  // maximum number of tries to locate an event
// width of the bracket at which they end, as a fraction of the increment; the limit is then exceeded in a jump
constexpr double narrowest = 1e-7;
constexpr int mostStalled = 3;  // number of consecutive tries that do not halve the distance to the limit
constexpr long longSearch = 40;  // iterations of a try after which the next try starts from its result
constexpr double locateShare = 1e-4;  // accuracy with which an event is located, as a fraction of its limit

constexpr double shortResponse = 0.1;  // of the last length: no displacement is estimated from a shorter load increase

// Increments of automatic length, in pseudo-time.
constexpr double longestBent = 1.0 / 7.0;  // maximum length if joints slide, open or close: enough points on curves
constexpr double longestFlow = 0.02;  // maximum length if bolts yield or slip
constexpr double shortestChosen = 2.5e-3;  // minimum length, unless there is no equilibrium
constexpr double finestCollapse = 0.02;  // length from which a collapse is accepted
constexpr double sameTurn = 0.8;  // of the rotation in a longer increment: a block turns in a jump
constexpr long fewPasses = 16;  // iterations that a long increment may take; without sliding it takes fewer
// the same for the last increment: often there is no equilibrium at the full load
constexpr long manyPasses = 20;
constexpr long mostInSearch = 400;  // pseudo-steps after which a shorter increment is tried

std::vector<Point> centroidsOf(const State& state) {
    std::vector<Point> centroids;
    for (const BlockMotion& block : state.blocks) centroids.push_back(block.centroid);
    return centroids;
}

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
    /// State reached at a point further along the load path.
    struct Reached {
        State state;
        double share = 0.0;
        bool atLimit = false;  // the first limit was located at this state
    };

    /// \param most the number of pseudo-steps after which the search ends as `Undecided`, within the total allowed.
    StepEnding equilibrium(State& state, double to, long most = std::numeric_limits<long>::max(),
                           bool followsFalls = true) {
        const double length = (to - progress_.done) * span();
        Eigen::VectorXd moved = expectedOver(length);
        StepEnding ending = equilibrium(state, {reached(), between(a_, b_, to)}, most, followsFalls, &moved);
        if (ending.ending == Ending::Done) noteResponse(moved, length);
        return ending;
    }

    /// \param moved as in `findEquilibrium`.
    StepEnding equilibrium(State& state, const LoadPath& path, long most = std::numeric_limits<long>::max(),
                           bool followsFalls = true, Eigen::VectorXd* moved = nullptr) {
        StaticSettings settings = settings_;
        settings.followsFalls = followsFalls;
        settings.maxSteps = most;
        return equilibrium(state, path, settings, moved);
    }

    StepEnding equilibrium(State& state, const LoadPath& path, StaticSettings settings, Eigen::VectorXd* moved) {
        if (progress_.moving()) settings.fallsFrom = &progress_.fallsFrom;
        settings.motionFollows = settings.motionFollows && isSameLoad(path.at, b_);
        settings.maxSteps = std::min(settings.maxSteps, settings_.maxSteps - progress_.solves);
        const long before = engine_.health.steps;
        StepEnding ending = findEquilibrium(engine_, state, loads_, path, settings, moved);
        progress_.solves += engine_.health.steps - before;
        if (ending.ending == Ending::Undecided && isWorkedOut())
            ending.message = "no verdict after " + std::to_string(progress_.solves) + " pseudo-steps: " + ending.message;
        return ending;
    }

    /// Estimated displacement over an increase of the load by `length`; empty if none is known.
    Eigen::VectorXd expectedOver(double length) const {
        const LoadResponse& last = progress_.response;
        if (last.moved.empty() || !(last.length > 0.0) || !(length > 0.0)) return {};
        const auto size = static_cast<Eigen::Index>(last.moved.size());
        return length / last.length * Eigen::Map<const Eigen::VectorXd>(last.moved.data(), size);
    }

    /// Keeps the displacement over an increase of the load, unless it is so short that round-off would dominate.
    void noteResponse(const Eigen::VectorXd& moved, double length) {
        LoadResponse& last = progress_.response;
        if (length > 0.0 && length >= shortResponse * last.length)
            last = {std::vector<double>(moved.begin(), moved.end()), length};
    }

    /// Searches for equilibrium where no shorter increment can be tried. Falling blocks are followed unless
    /// a bolt is beyond a limit, which is released first. An estimated displacement could loosen a block that friction
    /// holds.
    StepEnding searchToTheEnd(State& state, double to, long most = std::numeric_limits<long>::max()) {
        const LoadPoint before = reached(), at = between(a_, b_, to);
        if (boltLimits(state).empty()) return equilibrium(state, {before, at}, most, true);
        return followed(equilibrium(state, {before, at}, most, false), state, to);
    }

    /// Searches for equilibrium in parts of limited length until the allowed number of pseudo-steps is used up. If a
    /// part ends without a result, limits that were exceeded during it are released first.
    StepEnding searchOn(State& state, double to) {
        for (;;) {
            StepEnding ending = searchToTheEnd(state, to, mostInSearch);
            if (ending.ending != Ending::Undecided || ending.final || isWorkedOut() || lettingGo(ending, state)) return ending;
        }
    }

    /// Follows blocks that a search has seen to fall, unless limits of bolts are exceeded and must be released first.
    /// Their way is measured from the last equilibrium.
    StepEnding followed(StepEnding seen, State& state, double to) {
        if (seen.ending != Ending::NoEquilibrium || seen.final || passesBoltLimit(state)) return seen;
        const LoadPoint at = between(a_, b_, to);
        const std::vector<Point> from = centroidsOf(state_);
        StaticSettings settings = settings_;
        settings.fallsFrom = &from;
        return equilibrium(state, {at, at}, settings, nullptr);
    }

    bool passesLimit(const State& state) const {
        return worstLimit(heldLimits(engine_.model, state), 1.0 + reachedShare).has_value();
    }

    std::vector<Limit> boltLimits(const State& state) const {
        std::vector<Limit> limits = heldLimits(engine_.model, state);
        std::erase_if(limits, [](const Limit& limit) { return ofJoint(limit.kind); });
        return limits;
    }

    bool passesBoltLimit(const State& state) const {
        return worstLimit(boltLimits(state), 1.0 + reachedShare).has_value();
    }

    /// True if a search ended with moving blocks and limits have been exceeded (for `NoEquilibrium`: limits of bolts).
    /// They are released before anything is reported.
    bool lettingGo(const StepEnding& ending, const State& state) const {
        if (ending.final) return false;
        if (ending.ending == Ending::Undecided) return !isWorkedOut() && passesLimit(state);
        return ending.ending == Ending::NoEquilibrium && passesBoltLimit(state);
    }

    /// Records whether limits are released in moving rock, and where the blocks were before they moved.
    void setMoving(bool moving) {
        if (!moving) progress_.fallsFrom.clear();
        else if (!progress_.moving()) progress_.fallsFrom = centroidsOf(state_);
    }

    /// Keeps the moving blocks at the positions that they have reached.
    void leaveMoving(Reached moving) {
        state_ = std::move(moving.state);
        progress_.under = moving.share;
    }

    /// Accepts a moving state like an equilibrium, but limits are released before the load continues.
    StepEnding takeMoving(Reached moving) {
        setMoving(true);
        accept(std::move(moving));
        return {};
    }

    /// True if the pseudo-steps allowed since the last event or accepted increment are used up.
    bool isWorkedOut() const { return progress_.solves >= settings_.maxSteps; }

    static bool isMoving(const StepEnding& ending) {
        return ending.ending == Ending::NoEquilibrium || ending.ending == Ending::Undecided;
    }

    bool isChosen() const { return settings_.chosen && span() > 0.0; }

    /// Length of the increment in pseudo-time.
    double span() const { return b_.time - a_.time; }

    LoadPoint reached() const { return between(a_, b_, progress_.done); }

    std::optional<Limit> limit() const { return worstLimit(heldLimits(engine_.model, state_), progress_.least); }

    /// Increases the load by the current step, which is halved while no equilibrium is found, and at most to the first
    /// limit.
    StepEnding loadOn() {
        const double whole = 1.0 / piecesOfMotion();
        double& step = progress_.step;
        if (step == 0.0) step = whole;
        for (;;) {
            const double to = progress_.done + step >= 1.0 - 1e-12 ? 1.0 : progress_.done + step;
            State trial = state_;
            const bool less = step > finestIncrement * whole && !isSameLoad(a_, b_);
            StepEnding ending = less ? equilibrium(trial, to, mostInSearch, false) : searchToTheEnd(trial, to);
            if (isMoving(ending) && less && !isWorkedOut()) {
                if (to < 1.0 || standsAtFirst(whole)) {
                    step *= 0.5;
                    continue;
                }
                ending = followed(std::move(ending), trial, to);
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

    /// Increases the load by an automatically chosen length, and at most to the first limit.
    StepEnding loadByChoice() {
        for (;;) {
            const double to = nextShare();
            const double length = (to - progress_.done) * span();
            Reached next{state_, to};
            StepEnding ending = equilibriumWithin(next.state, to, patienceFor(length, to));
            const bool found = ending.ending == Ending::Done;
            if (found) ending = toFirstLimit(next);
            if (!isWorkedOut() && (isTooDear(ending, length) || (isMoving(ending) && isTooFar(length)))) {
                const bool last = isLast(length, to);
                if (last || isMoving(ending)) progress_.fails = to;
                if (!last) shorten(length, ending.ending);
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

    /// End of the next increment: equal parts of the remaining load, none longer than the next length to try, none
    /// beyond an increment in which a block turned too far, and none reaching the end of a failed increment while shorter
    /// ones can be tried.
    double nextShare() const {
        const double left = (1.0 - progress_.done) * span();
        const double longest = std::min(progress_.chosen.next, span() / piecesOfMotion());
        const double parts = std::ceil(left / longest * (1.0 - 1e-9));
        double next = parts <= 1.0 ? 1.0 : progress_.done + (1.0 - progress_.done) / parts;
        if (progress_.turnedTo > progress_.done) next = std::min(next, progress_.turnedTo);
        return progress_.fails > progress_.done ? std::min(next, nearerTo(progress_.fails)) : next;
    }

    /// Half of the distance to the point where no equilibrium was found, or all of it if that is short enough to accept
    /// a collapse. At the full load, nearly all of it is tried first.
    double nearerTo(double fails) const {
        const double way = fails - progress_.done;
        if (!isTooFar(way * span())) return fails;
        const double rest = std::min(finestCollapse / span(), 0.5 * way);
        return progress_.done + (isLast(way * span(), fails) ? way - rest : 0.5 * way);
    }

    /// True for an increment to the full load that can be divided. Unsupported rock falls there, when the forces that
    /// held it have become smaller than its weight.
    bool isLast(double length, double to) const { return to == 1.0 && !isLong(length) && isTooFar(length); }

    /// Accepts the state reached, unless too much happened within the increment; then a shorter one is tried next.
    bool take(Reached next) {
        ChosenLength& chosen = progress_.chosen;
        const double length = (next.share - progress_.done) * span();
        const PathReview review =
            reviewPath(engine_.model, state_, next.state, chosen.last > 0.0 ? length / chosen.last : 0.0);
        const double longest = review.straight ? 1.0 : review.boltsFlow ? longestFlow : longestBent;
        const bool jumps = review.turn > 1.0 && isJump(review.turn, next.share);
        const bool turns = review.turn > 1.0 && !jumps;
        const bool halve = review.error > 1.0 || turns;
        const bool tooLong = length > longest * (1.0 + 1e-9) || halve;
        if (tooLong && length > shortestChosen * (1.0 + 1e-9)) {
            if (turns) {
                progress_.turnedTo = next.share;
                progress_.turn = review.turn;
            }
            chosen.next = std::max(shortestChosen, std::min(longest, halve ? 0.5 * length : length));
            return false;
        }
        if (chosen.grows && 4.0 * std::max(review.error, review.turn) <= 1.0)
            chosen.next = std::max(chosen.next, 2.0 * length);
        chosen.next = std::min(chosen.next, longest);
        chosen.last = jumps ? 0.0 : length;
        if (jumps) progress_.response = {};
        accept(std::move(next));
        return true;
    }

    /// True if a block has turned nearly as far as in a longer increment: it jumps, and shorter ones would only locate
    /// the jump.
    bool isJump(double turn, double to) const {
        return to <= progress_.turnedTo && turn >= sameTurn * progress_.turn;
    }

    /// Number of iterations after which a shorter increment is tried first.
    long patienceFor(double length, double to) const {
        if (isLong(length)) return fewPasses;
        return isLast(length, to) ? manyPasses : std::numeric_limits<long>::max();
    }

    /// Searches for equilibrium; the search ends as `Stopped` once it has made more than `passes` iterations.
    StepEnding equilibriumWithin(State& state, double to, long passes) {
        left_ = passes;
        const std::function<bool()> asked = engine_.stopAsked;
        engine_.stopAsked = [this, &asked] { return left_-- <= 0 || (asked && asked()); };
        const bool mayBeShorter = isTooFar((to - progress_.done) * span());
        StepEnding ending = mayBeShorter ? equilibrium(state, to, mostInSearch, false) : searchToTheEnd(state, to);
        engine_.stopAsked = asked;
        return ending;
    }

    /// True if the search was given up or did not converge, and a shorter increment may succeed.
    bool isTooDear(const StepEnding& ending, double length) const {
        if (length <= shortestChosen * (1.0 + 1e-9)) return false;
        return ending.ending == Ending::Failed || (ending.ending == Ending::Stopped && left_ < 0);
    }

    /// True if an increment is longer than those allowed while joints slide, open or close.
    static bool isLong(double length) { return length > longestBent * (1.0 + 1e-9); }

    /// True if an increment may have failed only because it was too long: there may be an equilibrium at a smaller
    /// load.
    bool isTooFar(double length) const { return length > finestCollapse * (1.0 + 1e-9) && !isSameLoad(a_, b_); }

    /// Shortens the next increment. Lengths no longer increase unless this one was long and its search was given up or
    /// did not converge.
    void shorten(double length, Ending ending) {
        ChosenLength& chosen = progress_.chosen;
        const bool probed = ending != Ending::NoEquilibrium && isLong(length);
        chosen.next = isLong(length) ? longestBent : 0.5 * length;
        if (ending != Ending::NoEquilibrium) chosen.next = std::max(shortestChosen, chosen.next);
        chosen.grows = chosen.grows && probed;
    }

    /// Checks, if there is no equilibrium at the end of a load that has not begun yet, whether there is one under a
    /// minute part of it. A block that slides under this part slides under any larger part.
    bool standsAtFirst(double whole) {
        if (progress_.done > 0.0) return true;
        State trial = state_;
        return equilibrium(trial, finestIncrement * whole, mostInSearch, false).ending != Ending::NoEquilibrium;
    }

    /// Number of pieces of an increment in which prescribed displacements and dilation stay within the limit of a
    /// pseudo-step.
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

    /// Updates the bolt nodes, unless a limit has been reached. It is released first because it may no longer be
    /// reached with the new tributary lengths. Only the limits of anchored points are checked with the new lengths,
    /// since the point may have left the rock.
    StepEnding followUnlessAtLimit() {
        const std::optional<Limit> next = limit();
        const bool first = next && next->kind != LimitKind::Bond && next->kind != LimitKind::CurveEnd;
        return first ? StepEnding{} : follow();
    }

    /// Assigns the nodes to the blocks in which they lie now, with new tributary lengths, and finds the new
    /// equilibrium.
    StepEnding follow() {
        const double small = followShare * engine_.model.size;
        for (int round = 0; round < mostRounds && followBolts(engine_.model, state_) > small; ++round) {
            State trial = state_;
            StepEnding ending = equilibrium(trial, progress_.done);
            state_ = std::move(trial);
            if (ending.ending != Ending::Done) return ending;
        }
        return {};
    }

    /// Shortens the increment to the point where the first limit is reached, if any limit is exceeded.
    StepEnding toFirstLimit(Reached& over) {
        std::vector<Limit> atEnd = heldLimits(engine_.model, over.state);
        if (!worstLimit(atEnd, 1.0 + reachedShare)) return {};
        over.atLimit = true;
        LimitSearch search(progress_.done, heldLimits(engine_.model, state_), over.share, std::move(atEnd));
        Reached under{state_, progress_.done};  // state from which the tries start
        // smallest distance from the limit so far, as a fraction of the limit
        double nearest = std::numeric_limits<double>::max();
        int stalled = 0;  // tries since `nearest` was halved; equilibria are not exact enough for more
        for (int tries = 0;; ++tries) {
            const double middle = search.next();
            State trial = under.state;
            const long before = engine_.health.passes;
            StepEnding ending = equilibrium(trial, {between(a_, b_, under.share), between(a_, b_, middle)});
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
            if (tries > mostTries || search.width() <= narrowest) return {};  // the limit is exceeded in a jump
        }
    }

    /// Releases only the limit that is exceeded most; the others are checked at the equilibrium after its release.
    StepEnding releaseOne() {
        const std::vector<Limit> limits = heldLimits(engine_.model, state_);
        const std::optional<Limit> worst = worstLimit(limits, progress_.least);
        if (!worst) return {};  // in a checkpoint that was changed
        const Limit& released = *worst;
        noteCauses(limits);
        progress_.least = 1.0 - tieShare;
        progress_.solves = 0;
        progress_.chosen.last = 0.0;
        const double time = reached().time;
        progress_.lastRelease =
            releaseAndReport(engine_.model, state_, released, time, causeOf(released), observer_);
        if (!changesForces(engine_.model, released) && (!progress_.moving() || limit())) {
            observer_.afterEvent(state_, time);
            return progress_.moving() ? StepEnding{} : followUnlessAtLimit();
        }
        const std::optional<State> sliding = ifSliding(state_);
        StepEnding ending = balanceAgain();
        ending.cause = progress_.lastRelease;
        if (ending.ending != Ending::Done) return ending;
        observer_.afterEvent(state_, time);
        reportResticks(engine_.model, sliding, state_, time, progress_.lastRelease, observer_);
        return ending;
    }

    /// Finds the equilibrium after a release, at the same load.
    StepEnding balanceAgain() {
        State trial = state_;
        StepEnding ending = searchOn(trial, progress_.done);
        setMoving(lettingGo(ending, trial));
        state_ = std::move(trial);
        if (progress_.moving()) return {};  // limits exceeded during the motion are released next
        if (ending.ending != Ending::Done) return ending;
        ++state_.step;
        return follow();
    }

    /// Records the causes of the limits exceeded. A limit not exceeded before is attributed to the last release or,
    /// before the first release, to the load.
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
    long left_ = 0;  // iterations left in a search that may be given up
};

}  // namespace

StepEnding moveStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                      const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress) {
    return Move(engine, state, loads, a, b, settings, observer, progress).make();
}

}  // namespace keyblock
