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
constexpr double sureMoveShare = 0.25;  // of the smallest block's: contacts are looked for as far as that at least
constexpr double moveRoom = 1.5;  // over the move that the step before leads to expect: contacts are looked for so far
constexpr double drivenShare = 0.05;  // of the smallest block's: how far a motion or dilation drives in one search
constexpr double roomToDrive = 2.0;  // times as far, moves in one pseudo-step what is driven
constexpr double softestInertia = 1e-11;  // regularisation over the stiffest spring
constexpr double firstStep = 0.3;  // of the time in which what falls freely moves by the longest move
constexpr double bookedShare = 0.02;  // of a block's size: a longer path is accepted in pieces
constexpr double longestPiece = 0.1;  // the same where the forces are not those of blocks that fall or slide
constexpr double quietForce = 10.0;  // times the weight of the heaviest block that is not at rest: no larger unbalanced ones
constexpr double jumpShare = 1e-3;  // the same of one pseudo-step in which a joint slides, opens or closes
constexpr double shortestPseudoStep = 1e-7;  // over the longest pseudo-step
constexpr double solvedShare = 1e-3;  // of what may be left on a body at rest: so much a pseudo-step leaves of its balance
constexpr double solvedUnrest = 0.01;  // of what is off balance where it begins, if that is more
constexpr double solvedNode = 1e-6;  // of the forces at a node of a bolt: steel that flows shares its stretch by them
constexpr double wellBalanced = 1e-9;  // residual over the reference force that needs no better
constexpr double stillFalling = 0.1;  // of the residual before: so quick a fall is followed under the tolerance, too
constexpr double easilyBalanced = 0.03;  // of what may be left on bodies: a tower sums up what is left on its blocks
constexpr int easyPasses = 2;  // iterations for which that is worth a longer pseudo-step
constexpr double pathShare = 1e-4;  // of the longest move: a longer one may come in by another edge than it seemed
constexpr int mostPaths = 2;  // times that a pseudo-step is done again because it does
constexpr int mostPasses = 20;  // iterations of a pseudo-step
constexpr int sweepPatience = 15;  // iterations before such a step tries sweeps: with so little inertia they seldom help
constexpr double roughly = 0.1;  // residual at which one that has taken them is good enough to go on from
constexpr double unsettledEase = 0.5;  // of such a pseudo-step, for the next
constexpr double unsettledCut = 0.1;  // of one that is not
constexpr double swingCut = 0.3;  // of one after which steps go to and fro
constexpr double fadingSwing = 0.7;  // of the step before: such a swing dies out by itself
constexpr double noSwing = 1e3;  // over round-off: shorter moves are noise
constexpr int lockedSteps = 2;  // pseudo-steps with friction locked, when joints take up the run's first forces

/// How much longer the next pseudo-step may be after one that took so many iterations.
double easeAfter(int passes) { return passes <= 8 ? 4.0 : passes <= 20 ? 2.0 : passes <= 30 ? 1.0 : 0.5; }

double longestPseudoStep(const Model& model) {
    double mass = 0.0;
    for (const BlockModel& block : model.blocks) mass += block.mass;
    mass /= static_cast<double>(model.blocks.size());
    return mass > 0.0 ? std::sqrt(2.0 * mass / (softestInertia * model.stiffest)) : 1.0;
}

class Equilibrium {
public:
    Equilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path, const StaticSettings& settings)
        : engine_(engine), model_(engine.model), state_(state), loads_(loads), at_(path.at), settings_(settings),
          account_(std::in_place, engine.model, state, loads, path.before), booked_(state.blocks),
          falls_(engine.model, state, settings.body, settings.smallest),
          moved_(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model_.blocks.size()) + 3 * model_.nodes)),
          tolerance_(std::min(settings.unbalanced, engine.model.analysis.tolerance)),
          driven_(longestDrive(path.before, path.at) > 0.0),
          moveLimit_(driven_ ? roomToDrive * longestMoveOf(engine.model) : sureMoveShare * smallestSize(engine.model)),
          longest_(longestPseudoStep(engine.model)), dt_(firstPseudoStep()) {}

    StepEnding find() {
        for (long step = 0; step < settings_.maxSteps; ++step) {
            const Outcome outcome = tryStep(step);
            if (outcome == Outcome::Balanced) return balancedUnlessHidden();
            if (outcome == Outcome::Stopped) return {Ending::Stopped, "", {}};
            if (outcome == Outcome::Unsettled) return unsettled();
            if (outcome == Outcome::Moved && report_.converged && (someLeft() || (!settings_.followsFalls && someFall())))
                return moving(Ending::NoEquilibrium);
        }
        return moving(Ending::Undecided);
    }

private:
    enum class Outcome { Balanced, Moved, Repeat, Stopped, Unsettled };

    /// What moves in a pseudo-step [m].
    struct Moves {
        std::vector<double> blocks;  // of the corner that moves most
        double largest = 0.0;  // of a block or node
        double overLimit = 0.0;  // over what it may move
    };

    /// One pseudo-step from where the blocks are, unless they are balanced there. `Repeat`: nothing has moved, and the
    /// next one is shorter or knows its path.
    Outcome tryStep(long step) {
        reach_ = driven_ ? moveLimit_ : std::max(moveLimit_, moveRoom * expectedMove());
        searchContacts(paths_ > 0 ? &path_ : nullptr);
        const bool lock = taken_ < lockedSteps && state_.step == 0 && unloaded(state_);
        if (lock && !locked_) dt_ = longest_;  // nothing slides, so that no step is too long
        if (!lock && locked_) {
            dt_ = firstPseudoStep();
            lastStep_.resize(0);
        }
        locked_ = lock;
        StepProblem problem = buildStep(model_, state_, loads_, at_, {Inertia::Static, dt_, lock});
        if (balanced(problem, step) && !lock) {
            accept(problem);
            countAccepted(engine_, state_, residual_);
            return Outcome::Balanced;
        }
        if (const std::vector<int> loose = falls_.loosePieces(state_.blocks); !loose.empty()) return letGo(problem, loose);
        if (!driven_ && settled_ && mayBook()) return bookPath(problem);
        problem.mayLeave = mayLeave();
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        if (paths_ > 0) d = path_;
        else if (lastStep_.size() > 0) d = std::pow(dt_ / lastDt_, 2) * lastStep_;  // what falls goes on falling
        report_ = solveStep(engine_, problem, state_, d, needs());
        if (report_.stopped) return Outcome::Stopped;
        const bool goodEnough = mayBeRough() && !report_.singular && report_.residual < roughly;
        if (!report_.converged && !goodEnough) return shorten(unsettledCut);
        const Moves moves = movesOf(problem, d);
        if (moves.overLimit > 1.0) return shorten(std::clamp(0.9 / std::sqrt(moves.overLimit), 0.01, 0.9));
        if (paths_ < mostPaths && entersElsewhere(d, moves.largest)) return keepPath(d);
        if (!driven_ && settled_ && !jumped_ && isJump(problem, d)) {  // forces that were at rest fall off before it
            jumped_ = bookNext_ = true;
            return keepPath(d);
        }
        take(d, moves);
        return Outcome::Moved;
    }

    void searchContacts(const Eigen::VectorXd* path) {
        state_.contacts = findContacts(model_, state_.blocks, state_.contacts,
                                       {searchMargin(), false, true, path, &state_.energy.released, &corners_});
        meetDilated(state_, state_.contacts);
    }

    /// The forces are judged where the blocks come to, so that a step need not be solved well to be one towards rest.
    bool mayBeRough() const {
        return !driven_ && !usesMultipliers(model_) && model_.analysis.iteration != Iteration::OpenClose;
    }

    /// Of the block that moved most in the last pseudo-step, where it goes on in the next [m].
    double expectedMove() const {
        return lastStep_.size() > 0 ? std::pow(dt_ / lastDt_, 2) * lastLargest_ : 0.0;
    }

    StepNeeds needs() const {
        if (!mayBeRough()) return {.tolerance = tolerance_, .sweepsFrom = std::numeric_limits<int>::max()};
        return {.tolerance = tolerance_,
                .maxPasses = std::min(mostPasses, model_.analysis.maxPasses),
                .sweepsFrom = sweepPatience};
    }

    /// How far the search for contacts reaches [m].
    double searchMargin() const { return 2.0 * reach_ + widestOpening(state_); }

    /// History and energy of the path, from the forces where the bodies are.
    void accept(StepProblem& problem) {
        account_->add(state_, at_, moved_, problem);
        acceptStep(model_, state_, problem, Eigen::VectorXd::Zero(problem.unknowns()));
    }

    /// What moves so far follows its path: friction turns with it, and work is a sum over its pieces. A piece does not end
    /// where a corner has turned into its neighbour, and a force that is none tears at it, if that can wait.
    bool mayBook() const {
        const bool quiet = unrest_.force <= quietForce * heaviestRestless();
        return isPathOver(quiet ? bookedShare : longestPiece) || (quiet && bookNext_);
    }

    bool isPathOver(double share) const {
        for (std::size_t i = 0; i < booked_.size(); ++i)
            if ((state_.blocks[i].centroid - booked_[i].centroid).norm() > share * model_.blocks[i].size) return true;
        return false;
    }

    /// Weight of a block or cell that is not at rest [N].
    double heaviestRestless() const {
        double most = 0.0;
        for (const int body : unrest_.restless)
            if (blockOfBody(model_, body) >= 0) most = std::max(most, rest_.own[static_cast<std::size_t>(body)]);
        return most;
    }

    /// True where a joint slides, opens or closes so far that its force does not change in proportion to the way.
    bool isJump(const StepProblem& problem, const Eigen::VectorXd& d) const {
        std::vector<double> after;
        linkStrains(problem, d, after);
        for (std::size_t i = 0; i < after.size(); ++i) {
            const Link& link = problem.links[i];
            if (!ofContact(link.kind)) continue;
            const double least = std::min(model_.blocks[static_cast<std::size_t>(link.a)].size,
                                          model_.blocks[static_cast<std::size_t>(link.b)].size);
            if (std::abs(after[i] - link.strain) > jumpShare * least) return true;
        }
        return false;
    }

    /// Accepts the path so far, though nothing balances yet.
    Outcome bookPath(StepProblem& problem) {
        accept(problem);
        startPath();
        bookNext_ = false;
        return Outcome::Repeat;
    }

    void startPath() {
        booked_ = state_.blocks;
        moved_.setZero();
        account_.emplace(model_, state_, loads_, at_);
    }

    /// Takes out what is too small to decide and falls.
    Outcome letGo(StepProblem& problem, const std::vector<int>& rows) {
        accept(problem);
        excavate(model_, state_, rows);
        startPath();
        return Outcome::Repeat;
    }

    /// A step that did not settle, or went too far, is repeated with a shorter one, down to the shortest.
    Outcome shorten(double share) {
        ++engine_.health.stepCuts;
        dt_ *= share;
        return dt_ >= shortestPseudoStep * longest_ ? Outcome::Repeat : Outcome::Unsettled;
    }

    /// True where a corner comes in by another edge than it was looked for.
    bool entersElsewhere(const Eigen::VectorXd& d, double move) const {
        return move > pathShare * moveLimit_ &&
               !entrancesHold(model_, state_.blocks, state_.contacts, corners_, d);
    }

    /// The step is done again with contacts looked for along its path.
    Outcome keepPath(const Eigen::VectorXd& d) {
        path_ = d;
        ++paths_;
        return Outcome::Repeat;
    }

    void take(const Eigen::VectorXd& d, const Moves& moves) {
        paths_ = 0;
        settled_ = report_.converged;
        ++taken_;
        moveBodies(model_, state_, d);
        moved_ += d;
        falls_.note(moves.blocks, dt_, rest_.own);
        noteFarthest();
        drifts_ = lastStep_.size() > 0 && d.dot(lastStep_) > 0.5 * d.norm() * lastStep_.norm();
        lastDt_ = dt_;
        lastLargest_ = moves.largest;
        if (!locked_) {
            lastMove_ = moves.largest;
            dt_ = swings(d, moves.largest) ? swingCut * dt_ : nextStep(moves.overLimit);
        }
        lastStep_ = d;
    }

    /// True where a block that decides falls; shown by a pseudo-step half as long.
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

    /// Even the shortest step does not settle.
    StepEnding unsettled() const {
        const std::string worst = nameOfBody(model_, report_.worst);
        return named(Ending::Failed, report_.singular ? worst + " is held by nothing" : "no step settles near " + worst,
                     blockOfBody(model_, report_.worst));
    }

    bool isDeciding(int body) const { return blockOfBody(model_, body) >= 0 && falls_.decides(body); }

    /// At equilibrium, unless round-off hides too much of what a block weighs.
    StepEnding balancedUnlessHidden() {
        engine_.health.worst = {blockOfBody(model_, unrest_.body), unrest_.share, unrest_.force};
        const auto hidden = std::find_if(unrest_.undecidable.begin(), unrest_.undecidable.end(),
                                         [&](int block) { return falls_.decides(block); });
        if (hidden == unrest_.undecidable.end()) return {};
        const double penalty = model_.analysis.penaltyRatio * mostNoise / unrest_.noise;
        return {Ending::Undecided,
                "round-off hides " + rounded(unrest_.noise) + " of the weight of block " +
                    model_.blocks[static_cast<std::size_t>(*hidden)].name + "; with a penalty ratio of " +
                    rounded(penalty) + " or less it would not",
                unrest_.undecidable, {}, -1, true};
    }

    /// Takes over where the moving blocks had got to: history and energy of their path, whatever does not balance.
    StepEnding moving(Ending how) {
        searchContacts(nullptr);
        StepProblem problem = buildStep(model_, state_, loads_, at_, {Inertia::Static, dt_, false});
        accept(problem);
        ++state_.step;  // not the state before: it has a frame of its own
        if (how == Ending::NoEquilibrium) return named(how, "", mostMoved());
        if (unrest_.restless.empty())
            return named(how, "neither rest nor a collapse is shown: " + nameOfBody(model_, mostMoved()) + " has moved most",
                         mostMoved());
        return named(how, "neither rest nor a collapse is shown: " + nameOfBody(model_, unrest_.body) + " is " +
                              rounded(unrest_.share) + " of its weight off balance",
                     blockOfBody(model_, unrest_.body));
    }

    /// An ending that names the blocks that fall or have left their place, and those that they set moving; where there is
    /// none, `block`.
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

    /// No joint has carried anything yet: friction without normal forces would let everything slide.
    static bool unloaded(const State& state) {
        return std::all_of(state.contacts.begin(), state.contacts.end(),
                           [](const Contact& c) { return c.normalForce == 0.0 && !c.bonded; });
    }

    bool balanced(StepProblem& problem, long step) {
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
        correctFrictionLimits(problem, still);
        const Eigen::VectorXd net = netForce(problem, still);
        rest_ = restForces(model_, state_, problem, weightPerMass(model_, at_));
        unrest_ = farthestFromRest(model_, state_, problem, rest_, net, settings_.body);
        for (int i = 0; i < problem.unknowns(); ++i)
            if (problem.known[static_cast<std::size_t>(i)] && std::abs(problem.value[i]) > roundOff()) return false;
        const double reference = referenceForce(problem, still, net);
        const double before = std::exchange(residual_, residualNorm(problem, net) / reference);
        if (usesMultipliers(model_) && multiplierError(model_, state_, problem, still) > 1.0) return false;
        if (residual_ > settings_.unbalanced) return step > 0 && dt_ >= longest_ && isNoise(problem, net, before);
        if (unrest_.beyond > 1.0) return false;
        if (residual_ <= wellBalanced) return true;
        const bool easy = dt_ < longest_ && report_.passes <= easyPasses;
        return residual_ > stillFalling * before && !(easy && unrest_.beyond > easilyBalanced);  // not worth another step
    }

    /// What is left is due to round-off of the coordinates: it falls no more, and nothing drifts.
    bool isNoise(const StepProblem& problem, const Eigen::VectorXd& net, double before) const {
        if (lastMove_ <= roundOff()) return true;
        const bool stalls = residual_ > 0.9 * before;
        return stalls && !drifts_ && residualNorm(problem, net) <= placeNoise(problem, 0.25 * roundOff());
    }

    /// The next pseudo-step: longer after one that was easily solved, but not so long that what falls freely would go too
    /// far in it.
    double nextStep(double moveOverLimit) const {
        const double ease = report_.converged ? easeAfter(report_.passes) : unsettledEase;
        const double room = moveOverLimit > 0.0 ? std::sqrt(0.9 / moveOverLimit) : ease;
        return std::min(std::min(room, ease) * dt_, longest_);
    }

    /// Under gravity short enough for what is loose; but no inertia may resist what a motion drives.
    double firstPseudoStep() const {
        const double gravity = driven_ ? 0.0 : weightPerMass(model_, at_);
        return gravity > 0.0 ? std::min(longest_, firstStep * std::sqrt(2.0 * moveLimit_ / gravity)) : longest_;
    }

    Moves movesOf(const StepProblem& problem, const Eigen::VectorXd& d) const {
        Moves moves;
        moves.largest = nodeMove(problem, d);
        moves.overLimit = moves.largest / reach_;
        for (std::size_t i = 0; i < model_.blocks.size(); ++i) {
            const double move = blockMove(model_, problem, d, i);
            moves.blocks.push_back(move);
            moves.largest = std::max(moves.largest, move);
            const double most = driven_ ? moveLimit_ : std::min(reach_, moveShare * model_.blocks[i].size);
            moves.overLimit = std::max(moves.overLimit, move / most);
        }
        return moves;
    }

    /// Force that a pseudo-step may leave on each body [N].
    std::vector<double> mayLeave() const {
        std::vector<double> left;
        const double unrest = usesMultipliers(model_) ? 0.0 : std::min(1.0, unrest_.share);  // they want exact forces
        const double share = std::max(solvedShare * settings_.body, solvedUnrest * unrest);
        for (std::size_t i = 0; i < rest_.own.size(); ++i)
            left.push_back((i < model_.blocks.size() ? share : solvedNode) * rest_.own[i]);
        return left;
    }

    /// Steps to and fro that do not get shorter: what turns with the bodies is stiffer or softer than a step can see.
    bool swings(const Eigen::VectorXd& d, double move) const {
        if (lastStep_.size() == 0 || move < noSwing * roundOff()) return false;
        const double before = lastStep_.norm();
        return d.norm() > fadingSwing * before && d.dot(lastStep_) < -0.5 * d.norm() * before;
    }

    /// Moves smaller than this are lost in the coordinates [m].
    double roundOff() const { return 4.0 * std::numeric_limits<double>::epsilon() * model_.size; }

    /// Blocks and cells that no motion drives.
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

    /// For progress.
    void noteFarthest() {
        const int block = engine_.newest.moving = mostMoved();
        engine_.newest.moved =
            block < 0 ? 0.0 : falls_.moved(state_.blocks, block) * wholeSize(model_, wholeOf(model_, block));
    }

    /// The block that has moved farthest, over its own size.
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
    std::optional<StaticAccount> account_;  // of the path since it was booked last
    std::vector<BlockMotion> booked_;  // the blocks then
    Falls falls_;
    Eigen::VectorXd moved_;  // since then, summed over the pseudo-steps
    double tolerance_;
    bool driven_;  // by a prescribed motion or a dilation
    double moveLimit_;
    double reach_ = 0.0;  // as far as anything may move in the pseudo-step that comes [m]
    double longest_, dt_, lastDt_ = 0.0;
    RestForces rest_;  // when last judged
    Unrest unrest_;
    bool locked_ = false;  // friction, in the last pseudo-step
    bool halved_ = false;  // the pseudo-step that comes is half as long, to prove a fall
    bool settled_ = false;  // the last pseudo-step that was taken
    bool jumped_ = false;  // in a pseudo-step of this search, the first was
    bool bookNext_ = false;  // the path so far is booked before the next
    Eigen::VectorXd path_;  // of the step that is repeated
    int paths_ = 0;  // times that it was
    int taken_ = 0;
    SolveReport report_;  // of the last step
    double lastLargest_ = 0.0;  // move in the last pseudo-step [m]
    double lastMove_ = std::numeric_limits<double>::max();  // in the last without friction locked
    FoundCorners corners_;  // of the last search
    Eigen::VectorXd lastStep_;
    bool drifts_ = false;  // the last two steps went the same way
    double residual_ = std::numeric_limits<double>::max();  // over the reference force, when last judged
};

}  // namespace

StepEnding findEquilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path,
                           const StaticSettings& settings) {
    engine.newest.searched = 0;
    engine.newest.moving = -1;
    return Equilibrium(engine, state, loads, path, settings).find();
}

double longestMoveOf(const Model& model) { return drivenShare * smallestSize(model); }

}  // namespace keyblock
