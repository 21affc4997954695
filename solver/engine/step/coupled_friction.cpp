// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/coupled_friction.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr int mostDirections = 8, mostAtRest = 16;  // maximum number of GMRES iterations, in motion and at rest
constexpr int mostAccurate = 40;  // the same for accurate directions
constexpr double looseTolerance = 3e-2, tightTolerance = 1e-2;  // fraction of the net force, with sliding friction
// fraction of the net force, with sliding friction near rest: a larger error would add up to a drift
constexpr double restTolerance = 1e-4;
constexpr double accurateTolerance = 1e-4;  // fraction of the net force for accurate directions
constexpr double restShare = 0.1;  // times the residual: tolerance farther from rest, but not above the tight one
constexpr double nearBalance = 3e-3;  // residual up to which the tight tolerance applies
constexpr double roundOff = 1e-8;  // fraction of the net force, without sliding
constexpr double slidingTangent = 1e-3;  // fraction of a law's stiffness: a link with a smaller tangent is sliding
constexpr double exhausted = 1e-14;  // fraction of the first residual: GMRES has found the exact solution

/// A sliding link whose force changes by `factor` times the strain of the link that limits it.
struct Sliding {
    std::size_t limited = 0, from = 0;
    double factor = 0.0;  // multiplied by `Law::share` [N/m]
};

std::vector<Sliding> slidingLinks(const StepProblem& problem, const Trial& at) {
    std::vector<Sliding> result;
    for (const LimitPair& pair : problem.limitPairs) {
        const auto limited = static_cast<std::size_t>(pair.limited), from = static_cast<std::size_t>(pair.from);
        const Law& law = problem.links[limited].law;
        if (law.kind != LawKind::Capped || law.limit <= 0.0) continue;
        if (at.laws[limited].tangent > slidingTangent * law.stiffness || at.laws[from].tangent == 0.0) continue;
        const double force = pair.factor * at.laws[from].force;
        if (pair.rule == LimitPair::Rule::Push && force >= 0.0) continue;
        const double rise = pair.rule == LimitPair::Rule::Push ? -pair.factor : std::copysign(pair.factor, force);
        const double sense = at.laws[limited].force > 0.0 ? 1.0 : -1.0;
        result.push_back({limited, from, law.share * sense * rise * at.laws[from].tangent});
    }
    return result;
}

void freeOnly(const StepProblem& problem, Eigen::VectorXd& x) {
    for (int i = 0; i < problem.unknowns(); ++i)
        if (problem.known[i]) x[i] = 0.0;
}

/// The matrix of the step including the dependence of sliding friction on the normal forces: A + C.
class CoupledMatrix {
public:
    CoupledMatrix(const StepProblem& problem, const LinkRows& rows, const StepMatrix& matrix,
                  std::vector<Sliding> sliding, StepWork& work)
        : problem_(problem), rows_(rows), matrix_(matrix), sliding_(std::move(sliding)), work_(work) {}

    bool slides() const { return !sliding_.empty(); }

    /// The product (A + C)·x, where x is the solution of the factored system for `force`.
    Eigen::VectorXd times(const Eigen::VectorXd& x, const Eigen::VectorXd& force) {
        ++work_.products;
        Eigen::VectorXd sum = force;
        if (matrix_.exact()) {
            for (const Sliding& s : sliding_) add(s, rows_.rate(s.from, x.data()), sum);
        } else {
            sum = matrix_.product(problem_, rows_, x, rates_);
            for (const Sliding& s : sliding_) add(s, rates_[s.from], sum);
        }
        freeOnly(problem_, sum);
        return sum;
    }

private:
    void add(const Sliding& s, double rate, Eigen::VectorXd& sum) const {
        if (rate != 0.0) rows_.add(s.limited, s.factor * rate, sum.data());
    }

    const StepProblem& problem_;
    const LinkRows& rows_;
    const StepMatrix& matrix_;
    std::vector<Sliding> sliding_;
    StepWork& work_;
    std::vector<double> rates_;
};

}  // namespace

Direction coupledDirection(const StepProblem& problem, const LinkRows& rows, const Trial& at, StepMatrix& matrix,
                           double residual, bool accurate, StepWork& work) {
    Eigen::VectorXd net = at.net;
    freeOnly(problem, net);
    Eigen::VectorXd x = matrix.solve(net, work);
    CoupledMatrix coupled(problem, rows, matrix, slidingLinks(problem, at), work);
    const bool slides = coupled.slides();
    if (matrix.exact() && !slides) return {x};
    // Let M be the matrix of the factor, and r the net force left by x. GMRES solves (A + C)·M⁻¹·u = r; then M⁻¹·u is
    // added to x.
    const Eigen::VectorXd start = net - coupled.times(x, net);
    const bool rests = !problem.mayLeave.empty();
    const double inMotion = residual > nearBalance ? looseTolerance : tightTolerance;
    const double atRest = std::clamp(restShare * residual, restTolerance, tightTolerance);
    const double share = !slides ? roundOff : accurate ? accurateTolerance : rests ? atRest : inMotion;
    const int most = accurate ? mostAccurate : rests ? mostAtRest : mostDirections;
    const double first = start.norm(), enough = share * net.norm();
    if (!(first > enough)) return {x, slides};
    std::vector<Eigen::VectorXd> basis{start / first}, solved;
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(most + 1, most);
    Eigen::VectorXd weights;
    double left = first;
    bool done = false;
    for (int k = 0; k < most && !done; ++k) {
        solved.push_back(matrix.solve(basis.back(), work));
        Eigen::VectorXd next = coupled.times(solved.back(), basis.back());
        for (int j = 0; j <= k; ++j) {
            h(j, k) = basis[j].dot(next);
            next -= h(j, k) * basis[j];
        }
        h(k + 1, k) = next.norm();
        Eigen::VectorXd right = Eigen::VectorXd::Zero(k + 2);
        right[0] = first;
        const auto part = h.topLeftCorner(k + 2, k + 1);
        weights = part.colPivHouseholderQr().solve(right);
        left = (right - part * weights).norm();
        done = left <= enough || h(k + 1, k) < exhausted * first;
        basis.push_back(next / h(k + 1, k));
    }
    if (!done && !matrix.exact()) matrix.forget();
    Eigen::VectorXd sum = x;
    for (Eigen::Index k = 0; k < weights.size(); ++k) sum += weights[k] * solved[k];
    if (!done && !(left <= looseTolerance * net.norm())) return {x, slides, false};
    if (sum.dot(net) > 0.0) return {sum, slides};
    return {x, slides, false, sum};
}

}  // namespace keyblock
