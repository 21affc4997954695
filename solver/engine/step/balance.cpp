// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/balance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double digits = 8.0 * std::numeric_limits<double>::epsilon();
constexpr int refined = 2;  // passes: the second solves for what round-off left of the first
constexpr double ofOneBody = 10.0;  // times the tolerance: how far off a single body may be

template <class Vector>
auto part(const StepProblem& problem, const Vector& x, int body) {
    return x.segment(problem.first(body), problem.width(body));
}

/// Force of a link's share in one of its bodies, moments and strains turned into forces [N per unit of force].
double pull(const StepProblem& problem, int body, const Vector6& g) {
    return g.head(problem.width(body)).cwiseProduct(part(problem, problem.weight, body)).norm();
}

/// Summed forces of loads and links on every body, and what the links' digits leave of them [N].
void forcesAtPlay(const StepProblem& problem, const Eigen::VectorXd& d, std::vector<double>& forces,
                  std::vector<double>& noise) {
    std::vector<double> strains;
    linkStrains(problem, d, strains);
    forces = problem.ownForce;
    noise.assign(forces.size(), 0.0);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        const Link& link = problem.links[i];
        const LawResponse r = respond(problem, link, strains[i]);
        if (r.force == 0.0 && r.tangent == 0.0) continue;
        const int wa = problem.width(link.a);
        double size = std::abs(link.strain) + link.ga.head(wa).cwiseAbs().dot(part(problem, d, link.a).cwiseAbs());
        if (link.b >= 0)
            size += link.gb.head(problem.width(link.b)).cwiseAbs().dot(part(problem, d, link.b).cwiseAbs());
        const double force = link.law.share * std::abs(r.force);
        const double lost = digits * link.law.share * (r.tangent * size + std::abs(r.force));
        const auto add = [&](int body, const Vector6& g) {
            const double share = pull(problem, body, g);
            forces[static_cast<std::size_t>(body)] += share * force;
            noise[static_cast<std::size_t>(body)] += share * lost;
        };
        add(link.a, link.ga);
        if (link.b >= 0) add(link.b, link.gb);
    }
}

/// True where nothing of a body is free to move.
bool isDriven(const StepProblem& problem, int body) {
    const auto first = problem.known.begin() + problem.first(body);
    return std::all_of(first, first + problem.width(body), [](char known) { return known != 0; });
}

/// What the digits of loads and inertia leave on a body [N].
double ownNoise(const StepProblem& problem, const Eigen::VectorXd& d, int body) {
    const Eigen::VectorXd size = part(problem, d, body).cwiseAbs();
    Eigen::VectorXd sum = part(problem, problem.load, body).cwiseAbs();
    if (body < problem.blocks) sum += problem.blockStiffness[static_cast<std::size_t>(body)].cwiseAbs() * size;
    else sum += problem.nodeStiffness[static_cast<std::size_t>(body - problem.blocks)].cwiseProduct(size);
    return digits * sum.cwiseProduct(part(problem, problem.weight, body)).norm();
}

}  // namespace

Balance::Balance(const StepProblem& problem, const Eigen::VectorXd& d, int passes)
    : problem_(&problem), d_(&d), passes_(passes), net_(netForce(problem, d)) {
    problem.moves ? judgeBodies() : judgeScene();
}

void Balance::judgeScene() {
    reference_ = referenceForce(*problem_, *d_, net_);
    residual_ = residualNorm(*problem_, net_, &worst_) / reference_;
}

void Balance::judgeBodies() {
    forcesAtPlay(*problem_, *d_, forces_, noise_);
    double allLeft = 0.0, allForces = 0.0, largest = 0.0, worst = -1.0;
    for (int body = 0; body < problem_->blocks + problem_->nodes; ++body) {
        if (isDriven(*problem_, body)) continue;
        const auto at = static_cast<std::size_t>(body);
        allForces += forces_[at] * forces_[at];
        const double left = bodyResidual(*problem_, net_, body), ratio = left / (ofOneBody * forces_[at]);
        if (ratio > worst) {
            worst = ratio;
            worst_ = body;
        }
        if (left <= noiseOf(body)) continue;
        allLeft += left * left;
        largest = std::max(largest, ratio);
    }
    residual_ = allForces > 0.0 ? std::max(largest, std::sqrt(allLeft / allForces)) : 0.0;
    if (!std::isfinite(allLeft)) residual_ = allLeft;
}

/// A first solve leaves more than digits where springs are stiff; the second takes that away.
double Balance::noiseOf(int body) const {
    if (passes_ > 0 && passes_ < refined) return 0.0;
    const double own = ownNoise(*problem_, *d_, body);
    return passes_ == 0 ? own : own + noise_[static_cast<std::size_t>(body)];
}

bool Balance::within(double tolerance) const {
    if (problem_->moves || passes_ < refined) return residual_ <= tolerance;
    return residual_ <= std::max(tolerance, roundOffForce(*problem_, *d_) / reference_);
}

double Balance::slack(int body, double tolerance) const {
    if (!problem_->moves) return std::max(tolerance * reference_, roundOffForce(*problem_, *d_));
    const auto at = static_cast<std::size_t>(body);
    return std::max(tolerance * forces_[at], noiseOf(body));
}

}  // namespace keyblock
