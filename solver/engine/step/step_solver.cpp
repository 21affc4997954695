// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/step_solver.h"

#include "solver/engine/step/balance.h"
#include "solver/engine/step/coupled_friction.h"
#include "solver/engine/step/line_search.h"
#include "solver/engine/step/local_step.h"
#include "solver/engine/step/phase.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double balanced = 1e-9;  // a start with a residual up to this needs no solution
constexpr double stall = 0.2;  // length below which a line search has met wrong contact states
constexpr double astray = 2.0;  // times the previous residual: a step that leaves more has met wrong contact states
// times the previous residual: a full step that leaves no more, or converges, needs no line search
constexpr double improves = 0.2;
// iterations after which a step that increases the residual is shortened, to prevent cycles
constexpr int patience = 20;
constexpr double shortest = 1.0 / 50.0;  // lower bound of the shortened step
// maximum number of times that sweeps are tried in a step, and that they fail
constexpr int mostTries = 8, mostUseless = 2;
constexpr int mostJudged = 3;  // maximum number of displacements under swept forces that are tried in succession
constexpr double furtherShare = 0.5;  // of the tolerance: residual that further sweeps should leave
constexpr double easy = 2e-3;  // residual up to which a step needs no sweeps, nor a local solution at its start
constexpr double farFromBalance = 3e-3;  // residual above which the line search of Newton's method soon stalls
constexpr double helps = 0.2;  // times the previous residual: sweeps that leave less may continue
// Local solutions of the worst bodies: relative residual, over that of the worst body, from which bodies take part;
// largest share of all bodies that may take part at the start of a step at rest or under swept forces, and in motion
// after a stall; and factor of the residual below which they are kept
constexpr double involved = 0.1, mostAtStart = 0.1, mostAfterStall = 0.25, helpsLocally = 0.5;
// Local solutions of all unbalanced bodies and their neighbours after a shortened step at rest: number of iterations
// after which they are made after full steps, too; number of links up to which others are neighbours; largest share of
// all bodies; and factor of the sum of unbalanced forces below which they are kept
constexpr int mostFullSteps = 3, rings = 2;
constexpr double mostUnbalanced = 0.1, reduces = 0.95;
constexpr int mostLocal = 3;  // number of local solutions in succession
// Steps in motion: iterations after which loose blocks are solved for alone and wedged ones moved on, and after which
// sweeps that have failed are tried again
constexpr int localFrom = 2, sweepsAgain = 12;
constexpr double nearInMotion = 3e-2;  // residual up to which, in motion, a stall does not lead to sweeps
constexpr double hardlyHelps = 0.9;  // times the previous residual: a step that leaves more creeps
constexpr double productWork = 0.01;  // work of a product, in `workOf`
// Fraction of a flat law's secant that counts as its tangent after a line search has stalled: at first, and the factors
// after a further stall and after a full step. Below the least fraction it is left out.
constexpr double firstFirmness = 1e-3, firmer = 10.0, softer = 0.1, leastFirmness = 1e-4;
constexpr double nearlyFull = 0.8;  // step length from which the fraction is reduced
constexpr double overshoot = 3.0;  // times the slip of a contact: a step that adds more to it needs the secant
constexpr double similar = 10.0;  // factor up to which the secant of a sliding contact stays as it is in the factor
constexpr double leastHold = 1e-6;  // fraction of a law's stiffness, used if nothing restrains a body

std::vector<double> limitsOf(const StepProblem& problem) {
    std::vector<double> limits;
    for (const LimitPair& pair : problem.limitPairs)
        limits.push_back(problem.links[pair.limited].law.limit);
    return limits;
}

void setLimits(StepProblem& problem, const std::vector<double>& limits) {
    auto limit = limits.begin();
    for (const LimitPair& pair : problem.limitPairs)
        problem.links[pair.limited].law.limit = *limit++;
}

}  // namespace

int bodyOf(const StepProblem& problem, int unknown) {
    return unknown < 6 * problem.blocks ? unknown / 6 : problem.blocks + (unknown - 6 * problem.blocks) / 3;
}

/// Solution of one step.
class StepSolver::Newton {
public:
    /// \param trend of the contact forces; null: solves for some bodies of another step.
    Newton(StepProblem& problem, StepMatrix& matrix, ForceTrend* trend, const SolveSettings& settings,
           const std::function<bool()>& stopAsked)
        : problem_(problem), matrix_(matrix), trend_(trend), settings_(settings), stopAsked_(stopAsked),
          isLocal_(!trend), rows_(problem) {
        if (!isLocal_ && !rests()) carried_ = DualSweeps::carriedForces(problem_, rows_);
    }

    SolveReport from(Eigen::VectorXd& d) {
        begin(padded(d));
        if (settlesAtRest()) settleLocally(mostAtStart);
        while (report_.passes <= mostPasses() && !over()) {
            iterate();
            ++report_.passes;
            const bool isDue = length_ < nearlyFull || report_.passes > mostFullSteps;
            if (settlesAtRest() && isDue && !report_.singular) settleUnbalanced();
        }
        noteSweeps();
        d = unpadded(trial_.d);
        return report_;
    }

private:
    /// Starts from zero displacement if that needs no solution or if the step begins with sweeps, which start from the
    /// contact forces; otherwise from zero or from `guess`, whichever has the smaller residual: vibration from step to
    /// step does not show where a block will come to rest.
    void begin(Eigen::VectorXd guess) {
        if (settings_.fromGuess) return judge(trialAt(problem_, rows_, std::move(guess)));
        Eigen::VectorXd still = guess;
        for (int i = 0; i < problem_.unknowns(); ++i)
            if (!problem_.known[i]) still[i] = 0.0;
        const bool same = guess == still;
        judge(trialAt(problem_, rows_, std::move(still)));
        sweeps_ = beginsWithSweeps_ = mayKeepSweeping() && settings_.sweepsFirst->now() && report_.residual > easy;
        if (!same && !sweeps_ && !startsBalanced()) takeBetter(std::move(guess));
        startsEasy_ = report_.residual <= easy;
    }

    /// Records for the next solutions how this one was found. Those that start nearly balanced, continue another one, or
    /// have undone their first sweeps are not compared, nor are those that sweeps solve with the work of one
    /// factorization at most, because Newton's method takes at least one; of those that do not converge, only a stall
    /// counts.
    void noteSweeps() {
        const bool isCheap = beginsWithSweeps_ && report_.work.factorizations == 0 && workOf(report_.work) <= 1.0;
        if (startsEasy_ || !mayKeepSweeping() || dropped_ || isCheap) return;
        if (report_.converged || (stalled_ && !beginsWithSweeps_))
            settings_.sweepsFirst->note(beginsWithSweeps_, stalled_, workOf(report_.work));
    }

    /// The first sweeps of the step were of no use.
    void dropFirstSweeps() {
        if (!mayKeepSweeping()) return;
        settings_.sweepsFirst->drop();
        dropped_ = true;
    }

    /// Starts from `guess` instead if it has the smaller residual.
    void takeBetter(Eigen::VectorXd guess) {
        const double atRest = report_.residual;
        const std::vector<double> limits = limitsOf(problem_);
        Trial rest = std::move(trial_);
        judge(trialAt(problem_, rows_, std::move(guess)));
        if (!(report_.residual < atRest)) {
            setLimits(problem_, limits);
            trial_ = std::move(rest);
            judge();
        }
    }

    /// Hinges and crushing rock may change their states one after the other; while they keep Newton's method from full
    /// steps, each of them allows one more iteration.
    int mostPasses() const {
        if (firmness_ == 0.0) return settings_.maxPasses;
        int flat = 0;
        for (std::size_t i = 0; i < rows_.count(); ++i) flat += yields(i);
        return settings_.maxPasses + flat;
    }

    /// True for a hinge or crushing rock beyond its limit.
    bool yields(std::size_t i) const {
        const Law& law = problem_.links[i].law;
        return law.leastTangent > 0.0 && trial_.laws[i].tangent < law.stiffness;
    }

    bool slides(std::size_t i) const {
        const Link& link = problem_.links[i];
        return link.kind == LinkKind::Friction && trial_.laws[i].tangent < link.law.stiffness;
    }

    /// True for a sliding contact that a step at rest would have moved far beyond its slip.
    bool overshoots(std::size_t i) const { return !overshoots_.empty() && overshoots_[i] && slides(i); }

    void noteOvershoots(const std::vector<double>& rates) {
        overshoots_.resize(rates.size(), 0);
        for (std::size_t i = 0; i < rates.size(); ++i) {
            const double slip = std::abs(trial_.strains[i] - problem_.links[i].law.offset);
            if (slides(i) && std::abs(rates[i]) > overshoot * slip) overshoots_[i] = 1;
        }
    }

    bool maySweep() const { return !rests() && !isLocal_ && tries_ < mostTries; }
    bool mayKeepSweeping() const { return settings_.sweepsFirst; }
    bool rests() const { return !problem_.mayLeave.empty(); }

    /// True for a step in motion that the first iterations have not solved.
    bool isHard() const { return !rests() && report_.passes >= localFrom; }

    bool settlesAtRest() const { return rests() && !isLocal_; }

    void judge(Trial trial) {
        trial_ = std::move(trial);
        report_.work.products += 2;
        judge();
    }

    void judge() {
        balance_.emplace(problem_, rows_, trial_, report_.passes, settings_.tolerance);
        report_.residual = balance_->residual();
        report_.worst = balance_->worst();
    }

    bool over() {
        report_.stopped = stopAsked_ && stopAsked_();
        const bool unsolved = report_.passes == 0 && !helped_;
        report_.converged = !report_.stopped && (unsolved ? startsBalanced() : balance_->within(settings_.tolerance));
        return report_.stopped || report_.converged || report_.singular || !std::isfinite(report_.residual);
    }

    /// True if the start needs no solution. In motion, a tenth of the tolerance and of the force that moves a block
    /// noticeably may remain: contacts that hardly carry anything would change their states in a solution. In a search
    /// for equilibrium, blocks that creep are not at rest, however slow they are.
    bool startsBalanced() const {
        if (balance_->within(std::min(balanced, settings_.tolerance))) return true;
        return !problem_.startForce.empty() && balance_->within(balancedInMotion * settings_.tolerance) &&
               balance_->withinForces(problem_.startForce);
    }

    void iterate() {
        if (swept_) judgeSweeps();
        if (sweeps_ && tries_ < mostTries) return sweep();
        step();
        if (isCompared() && report_.passes == 0 && report_.residual > easy) sweeps_ = stalled_ = true;
    }

    /// True if the step begins with Newton's method to see whether it still stalls. After a trial of sweeps, the work of
    /// the whole step decides.
    bool isCompared() const {
        return !startsEasy_ && mayKeepSweeping() && !beginsWithSweeps_ && settings_.sweepsFirst->work > 0.0 &&
               !settings_.sweepsFirst->onTrial;
    }

    void sweep() {
        beforeSweeps_ = trial_;
        residualBefore_ = report_.residual;
        ++tries_;
        if (!dual_) beginSweeps();
        sweeps_ = false;
        if (dual_->possible() && sweepsSolve()) return;
        std::optional<Eigen::VectorXd> d;
        if (dual_->possible()) d = dual_->solve(beforeSweeps_, matrix(), report_.work);
        swept_ = d.has_value();
        if (!d) {
            tries_ = mostTries;
            if (report_.passes == 0) dropFirstSweeps();
        }
        judge(trialAt(problem_, rows_, d ? std::move(*d) : std::move(beforeSweeps_.d)));
    }

    /// Prepares sweeps from the forces before the step. In motion these are continued, unless the step is repeated from
    /// its last solution.
    void beginSweeps() {
        if (problem_.moves && !settings_.fromGuess) trend_->predict(problem_, carried_);
        dual_.emplace(problem_, rows_, carried_);
    }

    /// Sweeps, and continues while the displacement under the swept forces may solve the step. In motion, often only a
    /// few light blocks are not balanced under it; these are then solved for alone.
    bool sweepsSolve() {
        std::optional<Eigen::VectorXd> d = dual_->sweep(trial_, settings_.tolerance, report_.work);
        for (int judged = 1; d; ++judged) {
            judge(trialAt(problem_, rows_, std::move(*d)));
            settleLocally(mostAtStart);
            if (balance_->within(settings_.tolerance)) return true;
            if (judged == mostJudged) return false;
            const double share = std::min(1.0, settings_.tolerance / report_.residual);
            d = dual_->sweepOn(furtherShare * share, report_.work);
        }
        return false;
    }

    /// Continues sweeps that reduce the residual but not enough; undoes those that increase it. If the
    /// first sweeps of a step increase it, the next step begins with Newton's method.
    void judgeSweeps() {
        swept_ = false;
        if (report_.residual <= residualBefore_) {
            sweeps_ = report_.residual > farFromBalance && report_.residual < helps * residualBefore_;
            return;
        }
        judge(trialAt(problem_, rows_, std::move(beforeSweeps_.d)));
        if (++useless_ >= mostUseless) tries_ = mostTries;
        if (report_.passes == 1) dropFirstSweeps();
    }

    /// Makes one Newton step: the full step if that reduces the residual enough, otherwise the length that the line
    /// search finds.
    void step() {
        if (!factor()) return;
        const Direction direction = coupledDirection(problem_, rows_, trial_, matrix(), report_.residual, creeps_,
                                                     report_.work);
        if (std::exchange(creeps_, false) && direction.uphill.size() > 0 && passesWedge(direction.uphill)) return;
        std::vector<double> rates;
        rows_.rates(direction.displacement, rates);
        ++report_.work.products;
        std::swap(trial_, from_);
        const double before = report_.residual;
        const auto go = [&](double length) { goAlong(from_, direction.displacement, rates, length); };
        const std::vector<double> limits = limitsOf(problem_);
        go(1.0);
        if (report_.residual <= std::max(improves * before, rests() ? 0.0 : settings_.tolerance))
            return adaptFirmness(1.0);
        setLimits(problem_, limits);
        const double length = lineSearch(problem_, rows_, from_, direction.displacement, rates, direction.coupled);
        if (length < 1.0) go(length);
        adaptFirmness(length);
        if (rests() && length < stall) noteOvershoots(rates);
        double best = length, least = report_.residual;
        const bool mayCircle = direction.slides && report_.passes >= patience;
        for (double shorter = 0.5; mayCircle && least > before && shorter > shortest; shorter *= 0.5) {
            go(shorter);
            if (report_.residual < least) best = shorter, least = report_.residual;
        }
        if (report_.residual > least) go(best);
        creeps_ = isHard() && report_.residual > hardlyHelps * before;
        const bool strays = report_.residual > std::max(astray * before, easy);
        if (length < stall || strays) afterStall();
        else if (sweepsAreDue()) sweepAgain();
    }

    void goAlong(const Trial& from, const Eigen::VectorXd& direction, const std::vector<double>& rates, double length) {
        advance(problem_, rows_, from, direction, rates, length, trial_);
        ++report_.work.products;
        judge();
    }

    /// Where blocks are wedged, pushing them may increase friction by more than the push: then the resistance is
    /// negative, the balanced position of the present contact states lies uphill, and steps downhill creep away from it.
    /// Moves in the opposite direction, until contacts change so that the resistance is positive again.
    bool passesWedge(const Eigen::VectorXd& uphill) {
        const Eigen::VectorXd down = -uphill;
        std::vector<double> rates;
        rows_.rates(down, rates);
        ++report_.work.products;
        const Trial from = trial_;
        const std::vector<double> limits = limitsOf(problem_);
        const std::optional<double> length = longLineSearch(problem_, rows_, from, down, rates);
        if (length) goAlong(from, down, rates, *length);
        else setLimits(problem_, limits);
        return length.has_value();
    }

    /// A line search has met wrong contact states.
    void afterStall() {
        if (isHard() && !isLocal_) settleLocally(mostAfterStall);
        if (sweepsAreDue()) return sweepAgain();
        if (maySweep() && report_.residual > nearInMotion) sweeps_ = stalled_ = true;
    }

    bool sweepsAreDue() const {
        return !rests() && !isLocal_ && report_.passes % sweepsAgain == sweepsAgain - 1 && report_.residual > easy;
    }

    void sweepAgain() {
        tries_ = useless_ = 0;
        sweeps_ = true;
    }

    double shareOf(const std::vector<int>& bodies) const {
        return static_cast<double>(bodies.size()) / (problem_.blocks + problem_.nodes);
    }

    /// At rest, solves for the bodies that are not balanced and their neighbours while all others are held, as often as
    /// that leaves less, unless they are too many. A few loose blocks slide or open one after the other, and each of
    /// these changes would take an iteration of the whole step.
    void settleUnbalanced() {
        for (int made = 0; made < mostLocal; ++made) {
            const std::vector<int> unbalanced = balance_->unbalancedBodies(settings_.tolerance);
            if (unbalanced.empty() || shareOf(unbalanced) > mostUnbalanced) return;
            const std::vector<int> bodies = withNeighbours(problem_, rows_, unbalanced, rings);
            const double share = shareOf(bodies);
            if (share > mostUnbalanced) return;
            const double before = balance_->sum();
            Eigen::VectorXd old = trial_.d;
            judge(trialAt(problem_, rows_, solvedLocally(bodies, share)));
            if (!(balance_->sum() < reduces * before)) return judge(trialAt(problem_, rows_, std::move(old)));
        }
    }

    /// Solves for the worst bodies alone while all others are held, as often as that leaves much less, unless they are
    /// more than a share `most` of all bodies. Often a single loose block keeps the step from converging.
    void settleLocally(double most) {
        const double least = rests() ? easy : settings_.tolerance;
        for (int made = 0; made < mostLocal && report_.residual > least; ++made) {
            const std::vector<int> bodies = balance_->worstBodies(involved);
            const double share = shareOf(bodies);
            if (bodies.empty() || share > most) return;
            const double before = report_.residual;
            Eigen::VectorXd old = trial_.d;
            judge(trialAt(problem_, rows_, solvedLocally(bodies, share)));
            if (!(report_.residual < helpsLocally * before)) return judge(trialAt(problem_, rows_, std::move(old)));
            helped_ = true;
        }
    }

    /// The trial displacement with that of `bodies` solved again. The work counts by their share of all bodies.
    Eigen::VectorXd solvedLocally(const std::vector<int>& bodies, double share) {
        LocalStep local = localStep(problem_, rows_, bodies, trial_.d);
        Eigen::VectorXd own = local.taken(problem_, trial_.d), d = trial_.d;
        SolveSettings settings = settings_;
        settings.fromGuess = true;
        settings.sweepsFirst = nullptr;
        StepMatrix matrix;
        const std::function<bool()> never;  // `stopAsked_` may count its calls
        const SolveReport report = Newton(local.problem, matrix, nullptr, settings, never).from(own);
        report_.work.products += std::lround(share * workOf(report.work) / productWork);
        local.insert(problem_, own, d);
        return d;
    }

    /// The tangent of a flat law says nothing of where its force will change again: with it alone, Newton's method
    /// overshoots a thousandfold and the line search stalls. The secant bounds the law's potential from above, so that
    /// steps become short enough, but many; hence a fraction of it is used, which follows the step lengths. In motion
    /// inertia holds the rock and sweeps help; there it would double the work.
    void adaptFirmness(double length) {
        length_ = length;
        if (!rests()) return;
        if (length < stall) firmness_ = std::min(1.0, std::max(firmer * firmness_, firstFirmness));
        else if (length > nearlyFull) firmness_ = softer * firmness_ < leastFirmness ? 0.0 : softer * firmness_;
    }

    /// Tangent of a link in Newton's matrix, not multiplied by `Law::share`.
    double tangentOf(std::size_t i) const {
        const double tangent = trial_.laws[i].tangent;
        if (firmness_ == 0.0 || !(yields(i) || overshoots(i))) return tangent;
        const Law& law = problem_.links[i].law;
        return std::max(tangent, firmness_ * law.limit / std::abs(trial_.strains[i] - law.offset));
    }

    /// True for a contact that is barely closed or barely open, or whose friction is equally small or, in motion, as
    /// close to its limit: its state matters less than a change of the factor. In a search for equilibrium, contacts
    /// close to their limits decide, and keeping their state in the factor costs iterations.
    bool isIndifferent(std::size_t i) const {
        const Link& link = problem_.links[i];
        if (link.law.kind != LawKind::Gap && link.kind != LinkKind::Friction) return false;
        double force = link.law.share * std::abs(link.law.stiffness * (trial_.strains[i] - link.law.offset));
        if (problem_.moves && link.law.kind == LawKind::Capped)
            force = std::min(force, std::abs(force - link.law.share * link.law.limit));
        const auto minor = [&](int body) { return body < 0 || force <= balance_->slack(body, settings_.tolerance); };
        return minor(link.a) && minor(link.b);
    }

    /// The matrix, made ready for this step. A step that sweeps solve needs none.
    StepMatrix& matrix() {
        if (!std::exchange(isMatrixReady_, true)) matrix_.begin(problem_, rows_);
        return matrix_;
    }

    /// The weight of a link in the factor if it is similar to `weight`; otherwise `weight`. Any fraction of a secant
    /// serves, and a change of the factor costs work.
    double similarInFactor(std::size_t i, double weight) {
        const double known = matrix().weightInFactor(i).value_or(0.0);
        return known < similar * weight && weight < similar * known ? known : weight;
    }

    bool factor() {
        std::vector<double> weights(rows_.count());
        const auto take = [&](double least) {
            for (std::size_t i = 0; i < weights.size(); ++i) {
                weights[i] = rows_.law(i).share * tangentOf(i);
                if (firmness_ > 0.0 && overshoots(i)) weights[i] = similarInFactor(i, weights[i]);
                if (least > 0.0)
                    weights[i] = std::max(weights[i], rows_.law(i).share * least * problem_.links[i].law.stiffness);
                if (isIndifferent(i)) weights[i] = matrix().weightInFactor(i).value_or(weights[i]);
            }
            return matrix().factor(problem_, rows_, weights, report_.work);
        };
        if (take(0.0) < 0) return true;
        const int loose = take(leastHold);
        report_.singular = loose >= 0;
        if (report_.singular) report_.worst = bodyOf(problem_, loose);
        return !report_.singular;
    }

    StepProblem& problem_;
    StepMatrix& matrix_;
    bool isMatrixReady_ = false;
    ForceTrend* trend_;
    const SolveSettings& settings_;
    const std::function<bool()>& stopAsked_;
    bool isLocal_;  // solves for some bodies of another step
    LinkRows rows_;
    Trial trial_;
    Trial from_;  // of the last Newton step; kept for its memory
    std::optional<Balance> balance_;
    SolveReport report_;
    std::vector<double> carried_;  // forces of the links from which sweeps may start: before the step, or continued
    std::optional<DualSweeps> dual_;
    bool sweeps_ = false, swept_ = false;  // sweeps are to be made next; sweeps were made last
    bool startsEasy_ = true;  // the start is nearly balanced, or an earlier solution that is continued
    bool beginsWithSweeps_ = false;
    bool stalled_ = false, dropped_ = false;  // Newton's method stalled; the first sweeps were of no use
    bool creeps_ = false;  // the last step hardly reduced the residual
    bool helped_ = false;  // a local solution was kept
    double length_ = 1.0;  // of the last step, over the full one
    double firmness_ = 0.0;  // fraction of the secant of flat laws in Newton's matrix
    std::vector<char> overshoots_;  // per link: a step at rest would have moved it far beyond its slip; empty: none
    int tries_ = 0, useless_ = 0;
    Trial beforeSweeps_;
    double residualBefore_ = 0.0;
};

SolveReport StepSolver::solve(StepProblem& problem, Eigen::VectorXd& d, const SolveSettings& settings,
                              const std::function<bool()>& stopAsked) {
    const PhaseScope phase(Phase::Judge);
    for (int i = 0; i < problem.unknowns(); ++i)
        if (problem.known[i]) d[i] = problem.value[i];
    if (settings.openClose) return openClose(problem, d, settings, stopAsked);
    const SolveReport report = Newton(problem, matrix_, &trend_, settings, stopAsked).from(d);
    if (!settings.fromGuess) trend_.endStep();  // otherwise the step is repeated from its last solution
    return report;
}

}  // namespace keyblock
