// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/equilibrium.h"

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/multipliers.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/stage/activation.h"
#include "solver/engine/stage/energy_account.h"
#include "solver/engine/stage/falls.h"
#include "solver/engine/stage/rest.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"
#include "solver/scene/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double moveShare = 0.03;  // of a block's size: its longest move in one pseudo-step
constexpr double fallShare = 0.1;  // the same for a block that is seen to fall and is followed
constexpr double sureMoveShare = 0.25;  // of the smallest block's size: minimum range of the contact search
constexpr double moveRoom = 1.5;  // over the move expected from the last step: range of the contact search
constexpr double drivenShare = 0.05;  // of the smallest block's size: travel of a motion or dilation in one search
constexpr double roomToDrive = 2.0;  // over that travel: longest move in one driven pseudo-step
constexpr double softestInertia = 1e-11;  // regularising stiffness over the stiffest spring
constexpr double firstStep = 0.3;  // of the time in which a freely falling block moves by the longest move
constexpr double estimatedStep = 4.0;  // times that, if the search begins near an estimated displacement
constexpr double bookedShare = 0.02;  // of a block's size: a longer path is accepted in pieces
constexpr double longestPiece = 0.1;  // the same if the forces are larger than those of falling or sliding blocks
constexpr double quietForce = 10.0;  // times the weight of the heaviest block that is not at rest: limit of such forces
constexpr double jumpShare = 1e-3;  // of the smaller block's size: slip, opening or closure in one pseudo-step
constexpr double shortestPseudoStep = 1e-7;  // over the longest pseudo-step
constexpr double solvedShare = 1e-3;  // of the residual allowed on a body at rest: what a pseudo-step may leave
constexpr double solvedUnrest = 0.01;  // of the unbalanced force at its start, if that is more
constexpr double solvedNode = 1e-6;  // of the forces at a bolt node; they govern how yielding steel shares strain
// residual over the reference force that needs no improvement, apart from that before motion
constexpr double wellBalanced = 1e-9;
constexpr double stillFalling = 0.1;  // of the previous residual: such a fast decrease continues below the tolerance
constexpr double easilyBalanced = 0.03;  // of the residual allowed on bodies: in a tower, residuals add up
constexpr double leftBeforeMotion = 0.03;  // of the residual allowed on bodies: what may remain if motion follows
constexpr double solvedBeforeMotion = 0.01;  // the same for what the further pseudo-steps may leave
constexpr int mostBeforeMotion = 12;  // maximum number of further pseudo-steps for that
constexpr int mostRetries = 3;  // times in succession that one of them is repeated with half the length
constexpr int easyPasses = 2;  // iterations up to which this is worth a longer pseudo-step
constexpr double pathShare = 1e-4;  // of the longest move: a longer move may enter through another edge
// of the smaller block's size: a corner that enters no deeper than this through another edge than estimated is corrected
// in the next pseudo-step
constexpr double deepEntrance = 1e-5;
// times the unbalanced force allowed on a body: up to this, the second pseudo-step under a constant load is as long as
// the first
constexpr double slightUnrest = 10.0;
constexpr int mostPaths = 2;  // repetitions of a pseudo-step for this reason
constexpr int mostPasses = 40;  // largest number of iterations of a pseudo-step
constexpr double roughly = 0.1;  // residual up to which a pseudo-step without convergence is accepted
constexpr double unsettledEase = 0.5;  // factor for the step length after such a pseudo-step
constexpr double unsettledCut = 0.1;  // the same factor after a pseudo-step that is not accepted
constexpr double swingCut = 0.3;  // the same factor after pseudo-steps that go back and forth
constexpr double calmShare = 0.5;  // of the length that led to a swing: longest pseudo-step for some time after it
constexpr int calmSteps = 10;  // number of these pseudo-steps
constexpr double fadingSwing = 0.7;  // of the previous step: smaller oscillations die out by themselves
constexpr double noSwing = 1e3;  // times round-off: shorter moves are noise
constexpr int lockedSteps = 2;  // pseudo-steps with friction locked, while joints take up the run's first forces

/// Factor for the length of the next pseudo-step, from the number of iterations of the last one.
double easeAfter(int passes) { return passes <= 8 ? 4.0 : passes <= 20 ? 2.0 : passes <= 30 ? 1.0 : 0.5; }

double longestPseudoStep(const Model& model) {
    double mass = 0.0;
    for (const BlockModel& block : model.blocks) mass += block.mass;
    mass /= static_cast<double>(model.blocks.size());
    return mass > 0.0 ? std::sqrt(2.0 * mass / (softestInertia * model.stiffest)) : 1.0;
}

class Equilibrium {
public:
    /// \param expected an estimate of the displacement over the search, per unknown; empty: unknown.
    Equilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path, const StaticSettings& settings,
                Eigen::VectorXd expected)
        : engine_(engine), model_(engine.model), state_(state), loads_(loads), at_(path.at), settings_(settings),
          account_(std::in_place, engine.model, state, loads, path.before), booked_(state.blocks),
          falls_(engine.model, state, {settings.body, settings.smallest, settings.fallsFrom}),
          moved_(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model_.blocks.size()) + 3 * model_.nodes)),
          whole_(moved_), expected_(std::move(expected)),
          tolerance_(std::min(settings.unbalanced, engine.model.numerics.tolerance)),
          driven_(longestDrive(path.before, path.at) > 0.0), keepsLoad_(isSameLoad(path.before, path.at)),
          moveLimit_(driven_ ? roomToDrive * longestMoveOf(engine.model) : sureMoveShare * engine.model.smallest),
          longest_(longestPseudoStep(engine.model)), dt_(firstPseudoStep()) {}

    StepEnding find() {
        for (long step = 0; step < settings_.maxSteps; ++step) {
            const Outcome outcome = tryStep(step);
            if (outcome == Outcome::Balanced) return balancedUnlessHidden();
            if (outcome == Outcome::Stopped) return {Ending::Stopped, "", {}};
            if (outcome == Outcome::Unsettled) return unsettled();
            if (outcome != Outcome::Moved || !report_.converged) continue;
            const bool left = someLeft();
            if (!left && (settings_.followsFalls || !someFall())) continue;
            StepEnding ending = moving(Ending::NoEquilibrium);
            ending.final = left;
            return ending;
        }
        return moving(Ending::Undecided);
    }

    /// Displacement since the search began, per unknown.
    const Eigen::VectorXd& moved() const { return whole_; }

private:
    enum class Outcome { Balanced, Moved, Repeat, Stopped, Unsettled };

    /// Displacements in a pseudo-step [m].
    struct Moves {
        std::vector<double> blocks;  // of the corner of each block that moves most
        double largest = 0.0;  // of all blocks and nodes
        double overLimit = 0.0;  // displacement over its limit, at most
    };

    /// One pseudo-step from the present positions, unless they are balanced. `Repeat`: nothing has moved, and the next
    /// attempt has a shorter step or a known path.
    Outcome tryStep(long step) {
        reach_ = driven_ ? moveLimit_ : std::max(moveLimit_, moveRoom * expectedMove());
        searchContacts(paths_ > 0 ? &path_ : isEstimated() ? &expected_ : nullptr);
        const bool lock = taken_ < lockedSteps && state_.step == 0 && unloaded(state_);
        if (lock && !locked_) dt_ = longest_;  // nothing slides, so no step is too long
        if (!lock && locked_) {
            dt_ = firstPseudoStep();
            lastStep_.resize(0);
        }
        locked_ = lock;
        StepProblem problem = stepProblem(lock);
        if (balanced(problem, step) && !lock) {
            accept(problem);
            countAccepted(engine_, state_, loaded_ ? residual_ : 0.0);
            return Outcome::Balanced;
        }
        if (const std::vector<int> loose = falls_.loosePieces(state_.blocks); !loose.empty()) return letGo(problem, loose);
        if (!lock && !driven_ && settled_ && mayBook()) {
            bookPath(problem);
            problem = stepProblem(lock);
        }
        problem.mayLeave = mayLeave();
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        if (paths_ > 0) d = path_;
        else if (isEstimated()) d = expected_;
        else if (lastStep_.size() > 0) d = std::pow(dt_ / lastDt_, 2) * lastStep_;  // falling blocks continue to fall
        report_ = solveStep(engine_, problem, state_, d, needs());
        if (report_.stopped) return Outcome::Stopped;
        const bool goodEnough = mayBeRough() && !report_.singular && report_.residual < roughly;
        const bool within = report_.converged || (goodEnough && report_.residual <= tolerance_);
        if (improves_ && !within) return retryShorter();
        if (!report_.converged && !goodEnough) return isEstimated() ? dropEstimate() : shorten(unsettledCut);
        const Moves moves = movesOf(problem, d);
        if (improves_ && (moves.overLimit > 1.0 || entersElsewhere(d, moves.largest))) return retryShorter();
        if (moves.overLimit > 1.0) return shorten(std::clamp(0.9 / std::sqrt(moves.overLimit), 0.01, 0.9));
        if (paths_ < mostPaths && entersElsewhere(d, moves.largest)) return keepPath(d);
        if (!driven_ && settled_ && !jumped_ && isJump(problem, d)) {  // the path up to the jump is accepted first
            jumped_ = bookNext_ = true;
            return keepPath(d);
        }
        take(d, moves);
        return Outcome::Moved;
    }

    /// True for the first attempt of a search whose displacement can be estimated.
    bool isEstimated() const { return expected_.size() > 0; }

    /// \param path displacement over the coming pseudo-step, an estimate unless the step is repeated; null: at rest.
    void searchContacts(const Eigen::VectorXd* path) {
        state_.contacts = findContacts(
            model_, state_.blocks, state_.contacts,
            {searchMargin(), false, true, path, &state_.energy.released, &corners_, paths_ == 0, &engine_.neighbours});
        meetDilated(state_, state_.contacts);
    }

    /// Whether a rough solution is enough: the forces are evaluated at the positions that the blocks reach, so even a
    /// roughly solved step leads towards rest.
    bool mayBeRough() const {
        return !driven_ && !usesMultipliers(model_) && model_.analysis.iteration != Iteration::OpenClose;
    }

    /// Expected displacement, in the next pseudo-step, of the block that moved most in the last one [m].
    double expectedMove() const {
        return lastStep_.size() > 0 ? std::pow(dt_ / lastDt_, 2) * lastLargest_ : 0.0;
    }

    StepNeeds needs() const {
        const bool fromGuess = paths_ > 0 || isEstimated();
        if (!mayBeRough()) return {.tolerance = tolerance_, .fromGuess = fromGuess};
        return {.tolerance = tolerance_,
                .maxPasses = std::min(mostPasses, model_.numerics.maxPasses),
                .fromGuess = fromGuess};
    }

    /// Range of the search for contacts [m].
    double searchMargin() const { return 2.0 * reach_ + widestOpening(state_); }

    /// Accepts the history and energy of the path, with the forces at the present positions.
    void accept(StepProblem& problem) {
        account_->add(state_, at_, moved_, problem);
        acceptStep(model_, state_, problem, Eigen::VectorXd::Zero(problem.unknowns()));
    }

    /// Whether the path so far may be accepted. Blocks that have moved far must follow their path, because friction
    /// turns with it and work is a sum over its pieces. If possible, a piece does not end where a corner has rotated
    /// into its neighbour and a spurious force acts on it.
    bool mayBook() const {
        const bool quiet = unrest_.force <= quietForce * heaviestRestless();
        return isPathOver(quiet ? bookedShare : longestPiece) || (quiet && bookNext_);
    }

    bool isPathOver(double share) const {
        for (std::size_t i = 0; i < booked_.size(); ++i)
            if ((state_.blocks[i].centroid - booked_[i].centroid).norm() > share * model_.blocks[i].size) return true;
        return false;
    }

    /// Weight of the heaviest block or cell that is not at rest [N].
    double heaviestRestless() const {
        double most = 0.0;
        for (const int body : unrest_.restless)
            if (blockOfBody(model_, body) >= 0) most = std::max(most, rest_.own[body]);
        return most;
    }

    /// True if a joint slides, opens or closes so far that its force is not proportional to the displacement.
    bool isJump(const StepProblem& problem, const Eigen::VectorXd& d) const {
        std::vector<double> after;
        linkStrains(problem, d, after);
        for (std::size_t i = 0; i < after.size(); ++i) {
            const Link& link = problem.links[i];
            if (!ofContact(link.kind)) continue;
            const double least = std::min(model_.blocks[link.a].size,
                                          model_.blocks[link.b].size);
            if (std::abs(after[i] - link.strain) > jumpShare * least) return true;
        }
        return false;
    }

    /// The pseudo-step from the present positions.
    StepProblem stepProblem(bool lock) const {
        return buildStep(model_, state_, loads_, at_, {Inertia::Static, dt_, lock});
    }

    /// Accepts the path so far, although the forces are not balanced yet.
    void bookPath(StepProblem& problem) {
        accept(problem);
        startPath();
        bookNext_ = false;
    }

    void startPath() {
        booked_ = state_.blocks;
        moved_.setZero();
        account_.emplace(model_, state_, loads_, at_);
    }

    /// Removes falling pieces that are too small to decide the outcome.
    Outcome letGo(StepProblem& problem, const std::vector<int>& rows) {
        accept(problem);
        excavate(model_, state_, rows);
        startPath();
        return Outcome::Repeat;
    }

    /// Repeats a step that did not converge from the estimated displacement, starting from zero.
    Outcome dropEstimate() {
        expected_.resize(0);
        paths_ = 0;
        return Outcome::Repeat;
    }

    /// Repeats a step that did not converge or moved too far with a shorter one, down to the shortest.
    Outcome shorten(double share) {
        ++engine_.health.stepCuts;
        expected_.resize(0);
        dt_ *= share;
        return dt_ >= shortestPseudoStep * longest_ ? Outcome::Repeat : Outcome::Unsettled;
    }

    /// Repeats a pseudo-step that was to improve a balanced state with half the length. After too many attempts the state
    /// is accepted as it is.
    Outcome retryShorter() {
        dt_ *= 0.5;
        ++retries_;
        return Outcome::Repeat;
    }

    /// True if a corner enters through another edge than the search assumed.
    bool entersElsewhere(const Eigen::VectorXd& d, double move) const {
        const double deep = isEstimated() ? deepEntrance : 0.0;
        return move > pathShare * moveLimit_ &&
               !entrancesHold(model_, state_.blocks, state_.contacts, corners_, d, deep);
    }

    /// Repeats the step with contacts searched along its path.
    Outcome keepPath(const Eigen::VectorXd& d) {
        path_ = d;
        ++paths_;
        return Outcome::Repeat;
    }

    void take(const Eigen::VectorXd& d, const Moves& moves) {
        paths_ = 0;
        expected_.resize(0);
        settled_ = report_.converged;
        ++taken_;
        if (std::exchange(improves_, false)) ++beforeMotion_;
        retries_ = 0;
        moveBodies(model_, state_, d);
        moved_ += d;
        whole_ += d;
        falls_.note(moves.blocks, dt_, rest_.own);
        noteFarthest();
        drifts_ = lastStep_.size() > 0 && d.dot(lastStep_) > 0.5 * d.norm() * lastStep_.norm();
        lastDt_ = dt_;
        lastLargest_ = moves.largest;
        if (!locked_) {
            lastMove_ = moves.largest;
            dt_ = swings(d, moves.largest) ? afterSwing() : nextStep(moves.overLimit);
        }
        lastStep_ = d;
    }

    /// True if a deciding block falls, which is confirmed by a pseudo-step of half the length.
    bool someFall() {
        const auto some = [&](auto shown) {
            return std::any_of(unrest_.restless.begin(), unrest_.restless.end(),
                               [&](int body) { return isDeciding(body) && shown(body); });
        };
        const auto falls = [&](int body) { return falls_.falls(state_.blocks, body); };
        if (std::exchange(halved_, false))
            return some([&](int body) { return falls(body) && falls_.sameWhateverTheStep(body); });
        if (!some(falls)) return false;
        dt_ = std::min(dt_, 0.5 * lastDt_);
        halved_ = true;
        return false;
    }

    /// The ending if even the shortest step does not converge.
    StepEnding unsettled() const {
        const std::string worst = nameOfBody(model_, report_.worst);
        return named(Ending::Failed,
                     report_.singular ? worst + " is not restrained" : "no step converges near " + worst,
                     blockOfBody(model_, report_.worst));
    }

    bool isDeciding(int body) const { return blockOfBody(model_, body) >= 0 && falls_.decides(body); }

    /// Equilibrium, unless round-off hides too much of the weight of a block.
    StepEnding balancedUnlessHidden() {
        engine_.health.worst = {blockOfBody(model_, unrest_.body), unrest_.share, unrest_.force};
        const auto hidden = std::find_if(unrest_.undecidable.begin(), unrest_.undecidable.end(),
                                         [&](int block) { return falls_.decides(block); });
        if (hidden == unrest_.undecidable.end()) return {};
        const double penalty = model_.numerics.penaltyRatio * mostNoise / unrest_.noise;
        return {Ending::Undecided,
                "round-off hides " + rounded(unrest_.noise) + " of the weight of block " +
                    model_.blocks[*hidden].name + "; with a penalty ratio of " +
                    rounded(penalty) + " or less it would not",
                unrest_.undecidable, {}, -1, true};
    }

    /// The ending while blocks still move: the history and energy of their path are accepted, although forces are
    /// unbalanced.
    StepEnding moving(Ending how) {
        searchContacts(nullptr);
        StepProblem problem = stepProblem(false);
        accept(problem);
        ++state_.step;  // this state gets a frame of its own
        if (how == Ending::NoEquilibrium) return named(how, "", mostMoved());
        if (unrest_.restless.empty())
            return named(how,
                         "neither equilibrium nor collapse was found; " + nameOfBody(model_, mostMoved()) +
                             " has moved most",
                         mostMoved());
        return named(how,
                     "neither equilibrium nor collapse was found; the unbalanced force on " +
                         nameOfBody(model_, unrest_.body) + " is " + rounded(unrest_.share) + " times its weight",
                     blockOfBody(model_, unrest_.body));
    }

    /// An ending that lists the blocks that fall or have left their position, and the blocks that they set in motion.
    /// If there are none, it lists `block`.
    StepEnding named(Ending ending, std::string message, int block) const {
        StepEnding result{ending, std::move(message), {}};
        const auto add = [&](int row, std::vector<int>& to) {
            const int whole = wholeOf(model_, row);
            if (!std::count(result.blocks.begin(), result.blocks.end(), whole) && !std::count(to.begin(), to.end(), whole))
                to.push_back(whole);
        };
        for (const int row : freeRows())
            if (falls_.decides(row) && (falls_.hasLeft(state_.blocks, row) || falls_.falls(state_.blocks, row)))
                add(row, result.blocks);
        if (result.blocks.empty() && block >= 0) add(block, result.blocks);
        for (const int row : freeRows())
            if (falls_.decides(row) && falls_.follows(state_.blocks, row)) add(row, result.followers);
        return result;
    }

    /// True if no joint has carried a force yet. Without normal forces there is no friction, and everything would
    /// slide.
    static bool unloaded(const State& state) {
        return std::all_of(state.contacts.begin(), state.contacts.end(),
                           [](const Contact& c) { return c.normalForce == 0.0 && !c.bonded; });
    }

    bool balanced(StepProblem& problem, long step) {
        improves_ = false;
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
        correctFrictionLimits(problem, still);
        const Eigen::VectorXd net = netForce(problem, still);
        rest_ = restForces(model_, state_, problem, weightPerMass(model_, at_));
        unrest_ = farthestFromRest(model_, state_, problem, rest_, net, settings_.body);
        for (int i = 0; i < problem.unknowns(); ++i)
            if (problem.known[i] && std::abs(problem.value[i]) > roundOff()) return false;
        const double reference = referenceForce(problem, still, net);
        const double before = std::exchange(residual_, residualNorm(problem, net) / reference);
        loaded_ = reference > problem.floorForce;
        if (usesMultipliers(model_) && multiplierError(model_, state_, problem, still) > 1.0) return false;
        if (residual_ > settings_.unbalanced) return step > 0 && dt_ >= longest_ && isNoise(problem, net, before);
        if (unrest_.beyond > 1.0) return false;
        if (retries_ > mostRetries) return true;
        improves_ = mayImprove() && unrest_.beyond > leftBeforeMotion;
        if (improves_) return false;
        if (residual_ <= wellBalanced) return true;
        const bool easy = dt_ < longest_ && report_.passes <= easyPasses;
        return residual_ > stillFalling * before && !(easy && unrest_.beyond > easilyBalanced);  // not worth another step
    }

    /// True if a balanced state may be improved because motion follows.
    bool mayImprove() const {
        return settings_.motionFollows && beforeMotion_ < mostBeforeMotion && !locked_ && mayBeRough();
    }

    /// True if the residual is due to round-off of the coordinates: it no longer decreases, and nothing drifts.
    bool isNoise(const StepProblem& problem, const Eigen::VectorXd& net, double before) const {
        if (lastMove_ <= roundOff()) return true;
        const bool stalls = residual_ > 0.9 * before;
        return stalls && !drifts_ && residualNorm(problem, net) <= placeNoise(problem, 0.25 * roundOff());
    }

    /// The next pseudo-step: longer after one that was solved easily, but not so long that freely falling blocks would
    /// move too far in it.
    double nextStep(double moveOverLimit) const {
        double ease = report_.converged ? easeAfter(report_.passes) : unsettledEase;
        if (followsSlightUnrest()) ease = std::min(ease, 1.0);
        const double room = moveOverLimit > 0.0 ? std::sqrt(0.9 / moveOverLimit) : ease;
        return std::min(std::min(room, ease) * dt_, taken_ < calmFrom_ ? longestCalm_ : longest_);
    }

    /// The pseudo-step after a swing. For some pseudo-steps it stays well below the length that led to the swing, or a
    /// block that changes between two positions would do so for ever.
    double afterSwing() {
        longestCalm_ = std::max(calmShare * dt_, shortestPseudoStep * longest_);
        calmFrom_ = taken_ + calmSteps;
        return swingCut * dt_;
    }

    /// True after the first pseudo-step of a search under a constant load that began with little unbalanced force on
    /// every body, as after the failure of a small part. A second one of the same length keeps the factor.
    bool followsSlightUnrest() const {
        return keepsLoad_ && taken_ == 1 && beforeMotion_ == 0 && unrest_.beyond <= slightUnrest;
    }

    /// The first pseudo-step: under gravity it is short enough for loose blocks. If a motion drives blocks, no inertia
    /// may resist it.
    double firstPseudoStep() const {
        const double gravity = driven_ ? 0.0 : weightPerMass(model_, at_);
        const double share = isEstimated() ? estimatedStep * firstStep : firstStep;
        return gravity > 0.0 ? std::min(longest_, share * std::sqrt(2.0 * moveLimit_ / gravity)) : longest_;
    }

    Moves movesOf(const StepProblem& problem, const Eigen::VectorXd& d) const {
        Moves moves;
        moves.largest = nodeMove(problem, d);
        moves.overLimit = moves.largest / reach_;
        for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
            const double move = blockMove(model_, problem, d, i);
            moves.blocks.push_back(move);
            moves.largest = std::max(moves.largest, move);
            const bool followed = settings_.followsFalls && falls_.falls(state_.blocks, static_cast<int>(i));
            const double share = followed ? fallShare : moveShare;
            const double most = driven_ ? moveLimit_ : std::min(reach_, share * model_.blocks[i].size);
            moves.overLimit = std::max(moves.overLimit, move / most);
        }
        return moves;
    }

    /// Residual force that a pseudo-step may leave on each body [N].
    std::vector<double> mayLeave() const {
        std::vector<double> left;
        const double unrest = usesMultipliers(model_) ? 0.0 : std::min(1.0, unrest_.share);  // they need exact forces
        const double solved = improves_ ? solvedBeforeMotion : solvedShare;
        const double share = std::max(solved * settings_.body, solvedUnrest * unrest);
        for (std::size_t i = 0; i < rest_.own.size(); ++i)
            left.push_back((i < model_.blocks.size() ? share : solvedNode) * rest_.own[i]);
        return left;
    }

    /// True if steps go back and forth without getting shorter. Then forces that rotate with the bodies make them
    /// stiffer or softer than a step assumes.
    bool swings(const Eigen::VectorXd& d, double move) const {
        if (lastStep_.size() == 0 || move < noSwing * roundOff()) return false;
        const double before = lastStep_.norm();
        return d.norm() > fadingSwing * before && d.dot(lastStep_) < -0.5 * d.norm() * before;
    }

    /// Displacements below this are lost in the round-off of the coordinates [m].
    double roundOff() const { return 4.0 * std::numeric_limits<double>::epsilon() * model_.size; }

    /// Blocks and cells without a prescribed motion.
    std::vector<int> freeRows() const {
        std::vector<int> rows;
        for (int i = 0; i < static_cast<int>(model_.blocks.size()); ++i)
            if (std::none_of(loads_.motions.begin(), loads_.motions.end(),
                             [&](const PrescribedMotion& m) { return m.block == i; }))
                rows.push_back(i);
        return rows;
    }

    bool someLeft() const {
        const std::vector<int> rows = freeRows();
        return std::any_of(rows.begin(), rows.end(),
                           [&](int row) { return falls_.decides(row) && falls_.hasLeft(state_.blocks, row); });
    }

    /// Records the block that has moved farthest, for the progress display.
    void noteFarthest() {
        const int block = engine_.newest.moving = mostMoved();
        engine_.newest.moved =
            block < 0 ? 0.0 : falls_.moved(state_.blocks, block) * wholeSize(model_, wholeOf(model_, block));
    }

    /// The block that has moved farthest relative to its own size.
    int mostMoved() const {
        int most = -1;
        double farthest = 0.0;
        for (int i = 0; i < static_cast<int>(model_.blocks.size()); ++i) {
            const double moved = falls_.moved(state_.blocks, i);
            if (moved <= farthest || !falls_.decides(i)) continue;
            farthest = moved;
            most = i;
        }
        return most;
    }

    Engine& engine_;
    const Model& model_;
    State& state_;
    const Loads& loads_;
    const LoadPoint& at_;
    const StaticSettings& settings_;
    std::optional<StaticAccount> account_;  // of the path since it was last accepted
    std::vector<BlockMotion> booked_;  // the blocks at that time
    Falls falls_;
    Eigen::VectorXd moved_;  // displacement since then, summed over the pseudo-steps
    Eigen::VectorXd whole_;  // the same since the search began
    Eigen::VectorXd expected_;  // estimate of the displacement over the search; empty: unknown, or already used
    double tolerance_;
    bool driven_;  // by a prescribed motion or a dilation
    bool keepsLoad_;  // the load does not change in this search, e.g. after the failure of a part
    double moveLimit_;
    double reach_ = 0.0;  // limit of any displacement in the next pseudo-step [m]
    double longest_, dt_, lastDt_ = 0.0;
    RestForces rest_;  // at the last check
    Unrest unrest_;
    bool locked_ = false;  // friction was locked in the last pseudo-step
    bool halved_ = false;  // the next pseudo-step is half as long, to confirm a fall
    bool settled_ = false;  // the last accepted pseudo-step converged
    bool jumped_ = false;  // the first jump of this search has occurred
    bool bookNext_ = false;  // the path so far is accepted before the next pseudo-step
    Eigen::VectorXd path_;  // of the step that is repeated
    int paths_ = 0;  // number of its repetitions
    int taken_ = 0;
    int calmFrom_ = 0;  // number of pseudo-steps taken from which a swing no longer limits their length
    double longestCalm_ = 0.0;  // the limit until then
    bool improves_ = false;  // the state is balanced, and the pseudo-step is to leave less before motion follows
    int beforeMotion_ = 0, retries_ = 0;  // number of such pseudo-steps, and of failed attempts at the present one
    SolveReport report_;  // of the last step
    double lastLargest_ = 0.0;  // largest displacement in the last pseudo-step [m]
    double lastMove_ = std::numeric_limits<double>::max();  // the same, in the last one without locked friction [m]
    FoundCorners corners_;  // of the last search
    Eigen::VectorXd lastStep_;
    bool drifts_ = false;  // the last two steps had the same direction
    double residual_ = std::numeric_limits<double>::max();  // over the reference force, at the last check
    bool loaded_ = true;  // more than round-off acts, so that the residual is a share of something
};

}  // namespace

StepEnding findEquilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path,
                           const StaticSettings& settings, Eigen::VectorXd* moved) {
    engine.newest.searched = 0;
    engine.newest.moving = -1;
    Equilibrium search(engine, state, loads, path, settings, moved ? std::move(*moved) : Eigen::VectorXd());
    StepEnding ending = search.find();
    if (moved) *moved = search.moved();
    return ending;
}

double longestMoveOf(const Model& model) { return drivenShare * model.smallest; }

}  // namespace keyblock
