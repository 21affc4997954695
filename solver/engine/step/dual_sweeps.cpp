// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/dual_sweeps.h"

#include "solver/engine/step/phase.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

// Maximum number of sweeps before a factorization, which costs as much as 50 of them. Forces that have settled leave
// fewer further iterations, each of which may need another factorization.
constexpr int mostSweeps = 120;
constexpr double settled = 7e-6;  // change of the forces in a sweep, relative to the forces
constexpr int mostFurther = 12;  // maximum number of further sweeps at a time, after the forces have settled
constexpr double quickDecrease = 0.75;  // decrease of the mismatch in each of them that is assumed at first
constexpr int mixedSweeps = 4;  // number of differences between successive sweeps that Anderson mixing combines
constexpr double slidingFrom = 1.0 - 1e-9;  // fraction of the friction limit
constexpr double leastSweepHold = 1e-4;  // fraction of a law's stiffness, used if nothing else restrains a body

}  // namespace

DualSweeps::DualSweeps(StepProblem& problem, const LinkRows& rows, const std::vector<double>& carried)
    : problem_(problem), rows_(rows), swept_(problem, rows), forces_(swept_.count()), isSwept_(rows.count(), 0),
      mixing_(mixedSweeps) {
    for (std::size_t n = 0; n < swept_.count(); ++n) {
        forces_[n] = carried[swept_.linkOf(n)];
        isSwept_[swept_.linkOf(n)] = 1;
    }
    possible_ = swept_.possible() && std::any_of(problem.links.begin(), problem.links.end(),
                                                 [](const Link& link) { return ofContact(link.kind); });
}

std::vector<double> DualSweeps::carriedForces(const StepProblem& problem, const LinkRows& rows) {
    std::vector<double> forces(rows.count());
    for (std::size_t i = 0; i < rows.count(); ++i)
        forces[i] = respond(problem, problem.links[i], rows.start(i)).force;
    return forces;
}

/// Makes a sweep from the forces of the last one or from mixed forces. Mixed forces may be outside the ranges of their
/// laws until the sweep visits them.
void DualSweeps::sweepOnce(StepWork& work) {
    if (made_ > 0) mixing_.mix(changes_, forces_, swept_.placed());
    last_ = swept_.sweep(forces_, changes_);
    ++work.sweeps;
    ++made_;
}

bool DualSweeps::isSettled() const { return !(last_.changed > settled * settled * last_.forces); }

/// Estimated difference between the forces that the laws give and the swept forces, relative to these.
double DualSweeps::mismatch() const {
    return last_.forces > 0.0 ? swept_.mismatch(changes_) / std::sqrt(last_.forces) : 0.0;
}

/// Sweeps until the mismatch is no larger than `most`. Gives up if the last two sweeps, of which one followed a mixing,
/// show that it would take many more.
std::optional<Eigen::VectorXd> DualSweeps::sweepDownTo(double most, StepWork& work) {
    double last = 0.0, lastButOne = 0.0;
    for (int further = 0;; ++further) {
        const double now = mismatch();
        if (now <= most) return swept_.displacement();
        const int left = std::min(mostFurther - further, mostSweeps - made_);
        const double decrease = lastButOne > 0.0 ? std::sqrt(now / lastButOne) : quickDecrease;
        if (left <= 0 || !(now * std::pow(decrease, left) <= most)) return std::nullopt;
        lastButOne = std::exchange(last, now);
        sweepOnce(work);
    }
}

std::optional<Eigen::VectorXd> DualSweeps::sweep(const Trial& from, double tolerance, StepWork& work) {
    const PhaseScope phase(Phase::Sweep);
    holdTheRest(from);
    swept_.clipAndPlace(forces_);
    mixing_ = AndersonMixing(mixedSweeps);
    made_ = 0;
    do sweepOnce(work);
    while (!isSettled() && made_ < mostSweeps);
    if (!isSettled() || swept_.hasChains()) return std::nullopt;
    return sweepDownTo(tolerance, work);
}

std::optional<Eigen::VectorXd> DualSweeps::sweepOn(double share, StepWork& work) {
    const PhaseScope phase(Phase::Sweep);
    const double before = mismatch();
    if (before == 0.0) return std::nullopt;  // further sweeps change nothing
    return sweepDownTo(share * before, work);
}

DualSweeps::Straight DualSweeps::straight(std::size_t n) const {
    const Link& link = problem_.links[swept_.linkOf(n)];
    const double force = forces_[n], strain = swept_.strain(n, force);
    if (link.law.kind == LawKind::Capped && std::abs(force) >= slidingFrom * swept_.limit(n, forces_))
        return {force, 0.0, strain, force > 0.0 ? 1.0 : -1.0};
    if (link.law.kind == LawKind::Gap && force == 0.0) return {0.0, 0.0, strain, 0.0};
    return {force, swept_.tangent(n), strain, 0.0};
}

/// Keeps the links of bolt nodes on the tangents that they have in `from`, and the loads and prescribed displacements
/// constant, while the contact forces are swept.
void DualSweeps::holdTheRest(const Trial& from) {
    Eigen::VectorXd outer = padded(problem_.load);
    Eigen::VectorXd moves = Eigen::VectorXd::Zero(outer.size());
    for (int i = 0; i < problem_.unknowns(); ++i)
        if (problem_.known[i]) moves[i] = problem_.value[i];
    outer -= bodyProduct(problem_, moves);
    laws_.resize(rows_.count());
    for (std::size_t i = 0; i < rows_.count(); ++i)
        if (!isSwept_[i]) laws_[i] = {from.laws[i].force, from.laws[i].tangent, from.strains[i], 0.0};
    swept_.hold(outer, from);
}

/// Replaces every swept law by the straight line for the state that its force indicates, and factors the resulting
/// matrix.
/// \return false if the matrix is singular.
bool DualSweeps::straighten(StepMatrix& matrix, StepWork& work) {
    for (std::size_t n = 0; n < swept_.count(); ++n) laws_[swept_.linkOf(n)] = straight(n);
    const auto factored = [&](double least) {
        std::vector<double> weights(rows_.count());
        for (std::size_t i = 0; i < rows_.count(); ++i) {
            if (least > 0.0) laws_[i].tangent = std::max(laws_[i].tangent, least * problem_.links[i].law.stiffness);
            weights[i] = rows_.law(i).share * laws_[i].tangent;
        }
        return matrix.factor(problem_, rows_, weights, work) < 0;
    };
    return factored(0.0) || factored(leastSweepHold);
}

/// Evaluates the straight lines at `d` and limits the forces to the range of their laws; sliding links are at their
/// limits.
void DualSweeps::takeForces(const Eigen::VectorXd& d, StepWork& work) {
    std::vector<double> strains;
    rows_.strains(d, strains);
    ++work.products;
    for (std::size_t n = 0; n < swept_.count(); ++n) {
        const std::size_t i = swept_.linkOf(n);
        forces_[n] = laws_[i].at(strains[i]);
    }
    swept_.clip(forces_);
    for (std::size_t n = 0; n < swept_.count(); ++n)
        if (const double sliding = laws_[swept_.linkOf(n)].sliding; sliding != 0.0)
            forces_[n] = sliding * swept_.limit(n, forces_);
}

std::optional<Eigen::VectorXd> DualSweeps::solve(const Trial& from, StepMatrix& matrix, StepWork& work) {
    const PhaseScope phase(Phase::Sweep);
    if (!straighten(matrix, work)) return std::nullopt;
    Eigen::VectorXd net = padded(problem_.load) - bodyProduct(problem_, from.d);
    for (std::size_t i = 0; i < rows_.count(); ++i)
        if (const double force = laws_[i].at(from.strains[i]); force != 0.0)
            rows_.add(i, -rows_.law(i).share * force, net.data());
    const Eigen::VectorXd d = from.d + matrix.solve(net, work);
    ++work.products;
    takeForces(d, work);
    return d;
}

}  // namespace keyblock
