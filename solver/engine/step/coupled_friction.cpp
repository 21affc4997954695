// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/coupled_friction.h"

#include <Eigen/QR>

#include <cmath>

namespace keyblock {
namespace {

constexpr int mostDirections = 8;  // of GMRES
constexpr double exactEnough = 1e-2;  // of the force
constexpr double slidingTangent = 1e-3;  // of a law's stiffness: under less it slides
constexpr double exhausted = 1e-14;  // of the first residual: GMRES has found the exact answer

/// A sliding link whose force changes by `factor` times the strain of another.
struct Sliding {
    std::size_t limited = 0, from = 0;
    double factor = 0.0;  // share included [N/m]
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
        if (problem.known[static_cast<std::size_t>(i)]) x[i] = 0.0;
}

/// C·x
Eigen::VectorXd coupling(const StepProblem& problem, const LinkRows& rows, const std::vector<Sliding>& sliding,
                         const Eigen::VectorXd& x, StepWork& work) {
    ++work.products;
    Eigen::VectorXd force = Eigen::VectorXd::Zero(x.size());
    for (const Sliding& s : sliding)
        if (const double rate = rows.rate(s.from, x.data()); rate != 0.0)
            rows.add(s.limited, s.factor * rate, force.data());
    freeOnly(problem, force);
    return force;
}

}  // namespace

Direction coupledDirection(const StepProblem& problem, const LinkRows& rows, const Trial& at, StepMatrix& matrix,
                           StepWork& work) {
    Eigen::VectorXd net = at.net;
    freeOnly(problem, net);
    Eigen::VectorXd x = matrix.solve(net, work);
    const std::vector<Sliding> sliding = slidingLinks(problem, at);
    if (sliding.empty()) return {x};
    // (1 + C·A⁻¹)·u = −C·x by GMRES, and then x += A⁻¹·u
    const Eigen::VectorXd start = -coupling(problem, rows, sliding, x, work);
    const double first = start.norm(), enough = exactEnough * net.norm();
    if (!(first > enough)) return {x, true};
    std::vector<Eigen::VectorXd> basis{start / first}, solved;
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(mostDirections + 1, mostDirections);
    Eigen::VectorXd weights;
    bool done = false;
    for (int k = 0; k < mostDirections && !done; ++k) {
        solved.push_back(matrix.solve(basis.back(), work));
        Eigen::VectorXd next = basis.back() + coupling(problem, rows, sliding, solved.back(), work);
        for (int j = 0; j <= k; ++j) {
            h(j, k) = basis[static_cast<std::size_t>(j)].dot(next);
            next -= h(j, k) * basis[static_cast<std::size_t>(j)];
        }
        h(k + 1, k) = next.norm();
        Eigen::VectorXd right = Eigen::VectorXd::Zero(k + 2);
        right[0] = first;
        const auto part = h.topLeftCorner(k + 2, k + 1);
        weights = part.colPivHouseholderQr().solve(right);
        done = (right - part * weights).norm() <= enough || h(k + 1, k) < exhausted * first;
        basis.push_back(next / h(k + 1, k));
    }
    Eigen::VectorXd sum = x;
    for (Eigen::Index k = 0; k < weights.size(); ++k) sum += weights[k] * solved[static_cast<std::size_t>(k)];
    if (done && sum.dot(net) > 0.0) return {sum, true};
    return {x, true, false};
}

}  // namespace keyblock
