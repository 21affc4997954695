// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/stage/equilibrium.h"

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/multipliers.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/stage/energy_account.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/friction_limits.h"
#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace keyblock {
namespace {

constexpr double moveShare = 0.05;  // of the smallest block: the longest move of one pseudo-step
constexpr double softestInertia = 1e-11;  // regularisation over the stiffest spring
constexpr double farShare = 2.0;  // of a block's own size: moved so far it has left its place
constexpr double shortestStep = 1e-7;  // over the longest pseudo-step
constexpr double wellBalanced = 1e-9;  // residual over the reference force that needs no better
constexpr double stillFalling = 0.1;  // of the residual before: so quick a fall is followed under the tolerance, too
constexpr double pathShare = 1e-4;  // of the longest move: a longer one may come in by another edge than it seemed
constexpr int mostPaths = 2;  // times that a pseudo-step is done again because it does
constexpr double swingCut = 0.3;  // of a pseudo-step, where steps go to and fro
constexpr double fadingSwing = 0.7;  // of the step before: such a swing dies out by itself
constexpr double noSwing = 1e3;  // over round-off: shorter moves are noise
constexpr double lostShare = 30.0;  // of the longest move: a body that flies so far while a step is solved is given up
constexpr int morePasses = 5;  // times those of a step in motion: shorter pseudo-steps settle friction no sooner
constexpr int lockedSteps = 2;  // pseudo-steps with friction locked, when joints take up the run's first forces

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
          account_(engine.model, state, loads, path.before), places_(state.blocks),
          moved_(Eigen::VectorXd::Zero(6 * static_cast<Eigen::Index>(model_.blocks.size()) + 3 * model_.nodes)),
          tolerance_(std::min(settings.unbalanced, engine.model.analysis.tolerance)),
          moveLimit_(longestMoveOf(engine.model)), longest_(longestPseudoStep(engine.model)), dt_(longest_) {}

    StepEnding find() {
        for (int step = 0; step < settings_.maxSteps; ++step) {
            const Outcome outcome = tryStep(step);
            if (outcome == Outcome::Balanced) return {};
            if (outcome == Outcome::Stopped) return {Ending::Stopped, "", {}};
            if (outcome == Outcome::Unsettled) return unsettled();
            if (outcome == Outcome::Moved && !farBlocks().empty()) break;
        }
        return moving();
    }

private:
    enum class Outcome { Balanced, Moved, Repeat, Stopped, Unsettled };

    /// One pseudo-step from where the blocks are, unless they are balanced there. `Repeat`: nothing has moved, and the
    /// next one is shorter or knows its path.
    Outcome tryStep(int step) {
        searchContacts(paths_ > 0 ? &path_ : nullptr);
        const bool lock = taken_ < lockedSteps && state_.step == 0 && unloaded(state_);
        StepProblem problem = buildStep(model_, state_, loads_, at_, {Inertia::Static, dt_, lock});
        if (!lock && balanced(problem, step)) {
            accept(problem);
            countAccepted(engine_, state_, residual_);
            return Outcome::Balanced;
        }
        Eigen::VectorXd d = Eigen::VectorXd::Zero(problem.unknowns());
        report_ = solveStep(engine_, problem, state_, d, {.tolerance = tolerance_, .patience = morePasses, .farthest = lostShare * moveLimit_});
        if (report_.stopped) return Outcome::Stopped;
        const double move = report_.converged || report_.lost ? largestMove(model_, problem, d) : 0.0;
        if (!report_.converged || move > moveLimit_) return shorten(move);
        if (entersElsewhere(d, move)) return Outcome::Repeat;
        take(d, move, lock);
        return Outcome::Moved;
    }

    void searchContacts(const Eigen::VectorXd* path) {
        state_.contacts = findContacts(model_, state_.blocks, state_.contacts,
                                       {searchMargin(), false, true, path, &state_.energy.released});
        meetDilated(state_, state_.contacts);
    }

    /// How far the search for contacts reaches [m].
    double searchMargin() const { return 2.0 * moveLimit_ + widestOpening(state_); }

    /// History and energy of the path, from the forces where the bodies are.
    void accept(StepProblem& problem) {
        account_.add(state_, at_, moved_, problem);
        acceptStep(model_, state_, problem, Eigen::VectorXd::Zero(problem.unknowns()));
    }

    /// A step that did not settle, or went too far, is repeated with a shorter one, down to the shortest.
    Outcome shorten(double move) {
        ++engine_.health.stepCuts;
        dt_ *= move > moveLimit_ ? std::clamp(0.9 * std::sqrt(moveLimit_ / move), 0.01, 0.9) : 0.3;
        return dt_ >= shortestStep * longest_ ? Outcome::Repeat : Outcome::Unsettled;
    }

    /// True where a corner comes in by another edge than it was looked for; then the path of the step is kept for the
    /// next search.
    bool entersElsewhere(const Eigen::VectorXd& d, double move) {
        const bool searchAgain = paths_ < mostPaths && move > pathShare * moveLimit_ &&
                                 !entrancesHold(model_, state_.blocks, state_.contacts, searchMargin(), d);
        if (!searchAgain) return false;
        path_ = d;
        ++paths_;
        return true;
    }

    void take(const Eigen::VectorXd& d, double move, bool locked) {
        paths_ = 0;
        ++taken_;
        moveBodies(model_, state_, d);
        moved_ += d;
        if (!locked) lastMove_ = move;
        drifts_ = lastStep_.size() > 0 && d.dot(lastStep_) > 0.5 * d.norm() * lastStep_.norm();
        dt_ = swings(d, move) ? swingCut * dt_ : longer(move);
        lastStep_ = d;
    }

    /// Even the shortest step does not settle.
    StepEnding unsettled() const {
        const std::string worst = nameOfBody(model_, report_.worst);
        return named(Ending::Failed, report_.singular ? worst + " is held by nothing" : "no step settles near " + worst,
                     blockOfBody(model_, report_.worst));
    }

    /// Takes over where the moving blocks had got to: history and energy of their path, whatever does not balance.
    StepEnding moving() {
        searchContacts(nullptr);
        StepProblem problem = buildStep(model_, state_, loads_, at_, {Inertia::Static, dt_, false});
        accept(problem);
        ++state_.step;  // not the state before: it has a frame of its own
        return named(Ending::NoEquilibrium, "", mostMoved());
    }

    /// An ending that names the blocks that have left their place; where there is none, `block`.
    StepEnding named(Ending ending, std::string message, int block) const {
        StepEnding result{ending, std::move(message), farBlocks()};
        if (result.blocks.empty() && block >= 0) result.blocks.push_back(block);
        return result;
    }

    /// No joint has carried anything yet: friction without normal forces would let everything slide.
    static bool unloaded(const State& state) {
        return std::all_of(state.contacts.begin(), state.contacts.end(),
                           [](const Contact& c) { return c.normalForce == 0.0 && !c.bonded; });
    }

    bool balanced(StepProblem& problem, int step) {
        for (int i = 0; i < problem.unknowns(); ++i)
            if (problem.known[static_cast<std::size_t>(i)] && std::abs(problem.value[i]) > roundOff()) return false;
        const Eigen::VectorXd still = Eigen::VectorXd::Zero(problem.unknowns());
        correctFrictionLimits(problem, still);
        const Eigen::VectorXd net = netForce(problem, still);
        const double reference = referenceForce(problem, still, net);
        const double before = std::exchange(residual_, residualNorm(problem, net) / reference);
        if (usesMultipliers(model_) && multiplierError(model_, state_, problem, still) > 1.0) return false;
        if (residual_ > settings_.unbalanced) return step > 0 && dt_ >= longest_ && isNoise(problem, net, before);
        return residual_ <= wellBalanced || residual_ > stillFalling * before;  // no longer worth a pseudo-step
    }

    /// What is left is due to round-off of the coordinates: it falls no more, and nothing drifts.
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

    std::vector<int> farBlocks() const {
        std::vector<int> far;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const bool driven = std::any_of(loads_.motions.begin(), loads_.motions.end(),
                                            [&](const PrescribedMotion& m) { return m.block == static_cast<int>(i); });
            const double moved = (state_.blocks[i].centroid - places_[i].centroid).norm();
            if (!driven && moved > farShare * model_.blocks[i].size) far.push_back(static_cast<int>(i));
        }
        return far;
    }

    /// The block that has moved farthest, over its own size.
    int mostMoved() const {
        int most = -1;
        double farthest = 0.0;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const double moved = (state_.blocks[i].centroid - places_[i].centroid).norm() / model_.blocks[i].size;
            if (moved <= farthest) continue;
            farthest = moved;
            most = static_cast<int>(i);
        }
        return most;
    }

    Engine& engine_;
    const Model& model_;
    State& state_;
    const Loads& loads_;
    const LoadPoint& at_;
    const StaticSettings& settings_;
    const StaticAccount account_;
    const std::vector<BlockMotion> places_;  // at the start
    Eigen::VectorXd moved_;  // since then, summed over the pseudo-steps
    double tolerance_;
    double moveLimit_;
    double longest_, dt_;
    Eigen::VectorXd path_;  // of the step that is repeated
    int paths_ = 0;  // times that it was
    int taken_ = 0;
    SolveReport report_;  // of the last step
    double lastMove_ = std::numeric_limits<double>::max();
    Eigen::VectorXd lastStep_;
    bool drifts_ = false;  // the last two steps went the same way
    double residual_ = std::numeric_limits<double>::max();  // over the reference force, when last judged
};

}  // namespace

StepEnding findEquilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path,
                           const StaticSettings& settings) {
    return Equilibrium(engine, state, loads, path, settings).find();
}

double longestMoveOf(const Model& model) { return moveShare * smallestSize(model); }

}  // namespace keyblock
