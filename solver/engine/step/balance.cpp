// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/balance.h"

#include "solver/engine/step/step_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

constexpr double digits = 8.0 * std::numeric_limits<double>::epsilon();
constexpr int refined = 2;  // iterations: the second one corrects the round-off error of the first
constexpr double ofOneBody = 10.0;  // times the tolerance: limit for a single body

/// Round-off error of the loads and the inertia force on each body [N].
std::vector<double> ownNoise(const StepProblem& problem, const Eigen::VectorXd& d) {
    std::vector<double> noise;
    noise.reserve(problem.blocks + problem.nodes);
    for (const Matrix6& stiffness : problem.blockStiffness) {
        const int at = problem.first(static_cast<int>(noise.size()));
        const Vector6 size = d.segment<6>(at).cwiseAbs();
        const Vector6 sum = problem.load.segment<6>(at).cwiseAbs() + stiffness.cwiseAbs() * size;
        noise.push_back(digits * sum.cwiseProduct(problem.weight.segment<6>(at)).norm());
    }
    for (const Eigen::Vector3d& stiffness : problem.nodeStiffness) {
        const int at = problem.first(static_cast<int>(noise.size()));
        const Eigen::Vector3d size = d.segment<3>(at).cwiseAbs();
        const Eigen::Vector3d sum = problem.load.segment<3>(at).cwiseAbs() + stiffness.cwiseProduct(size);
        noise.push_back(digits * sum.cwiseProduct(problem.weight.segment<3>(at)).norm());
    }
    return noise;
}

}  // namespace

Balance::Balance(const StepProblem& problem, const LinkRows& rows, const Trial& trial, int passes, double tolerance)
    : problem_(&problem), rows_(&rows), trial_(&trial), passes_(passes) {
    addUpForces();
    if (passes_ == 0) noise_ = ownNoise(*problem_, trial_->d);
    compareBodies();
    if (passes_ < refined || within(tolerance)) return;
    addUpNoise();
    compareBodies();
}

/// Adds up the magnitudes of the loads and link forces on each body.
void Balance::addUpForces() {
    forces_ = problem_->ownForce;
    for (std::size_t i = 0; i < rows_->count(); ++i) {
        if (trial_->laws[i].force == 0.0) continue;
        const double force = rows_->law(i).share * std::abs(trial_->laws[i].force);
        forces_[rows_->bodyA(i)] += rows_->pullOnA(i) * force;
        if (rows_->bodyB(i) >= 0) forces_[rows_->bodyB(i)] += rows_->pullOnB(i) * force;
    }
}

/// Adds up the round-off errors of these forces. The error of a first solution is larger if springs are stiff; a second
/// solution corrects it.
void Balance::addUpNoise() {
    noise_ = ownNoise(*problem_, trial_->d);
    const Eigen::VectorXd& d = trial_->d;
    for (std::size_t i = 0; i < rows_->count(); ++i) {
        const LawResponse& r = trial_->laws[i];
        if (r.force == 0.0 && r.tangent == 0.0) continue;
        const double* g = rows_->gradient(i);
        double size = std::abs(problem_->links[i].strain);
        for (int k = 0; k < 6; ++k) size += std::abs(g[k] * d[rows_->firstOfA(i) + k]);
        for (int k = 0; k < 6; ++k) size += std::abs(g[6 + k] * d[rows_->firstOfB(i) + k]);
        const double lost = digits * rows_->law(i).share * (r.tangent * size + std::abs(r.force));
        noise_[rows_->bodyA(i)] += rows_->pullOnA(i) * lost;
        if (rows_->bodyB(i) >= 0) noise_[rows_->bodyB(i)] += rows_->pullOnB(i) * lost;
    }
}

void Balance::compareBodies() {
    double allLeft = 0.0, allForces = 0.0, largest = 0.0, worst = -1.0;
    beyond_ = 0.0;
    for (int body = 0; body < problem_->blocks + problem_->nodes; ++body) {
        if (isDriven(*problem_, body)) continue;
        const std::size_t at = body;
        allForces += forces_[at] * forces_[at];
        const double left = bodyResidual(*problem_, trial_->net, body), ratio = left / (ofOneBody * forces_[at]);
        if (ratio > worst) {
            worst = ratio;
            worst_ = body;
        }
        if (left <= noiseOf(body)) continue;
        if (!problem_->mayLeave.empty()) beyond_ = std::max(beyond_, left / problem_->mayLeave[at]);
        allLeft += left * left;
        largest = std::max(largest, ratio);
    }
    residual_ = allForces > 0.0 ? std::max(largest, std::sqrt(allLeft / allForces)) : 0.0;
    if (!std::isfinite(allLeft)) residual_ = allLeft;
}

std::vector<int> Balance::worstBodies(double share) const {
    std::vector<int> bodies;
    if (worst_ < 0) return bodies;
    const auto left = [&](int body) { return bodyResidual(*problem_, trial_->net, body); };
    const double least = share * left(worst_) / forces_[worst_];
    for (int body = 0; body < problem_->blocks + problem_->nodes; ++body)
        if (left(body) > std::max(noiseOf(body), least * forces_[body])) bodies.push_back(body);
    return bodies;
}

std::vector<int> Balance::unbalancedBodies(double tolerance) const {
    std::vector<int> bodies;
    for (int body = 0; body < problem_->blocks + problem_->nodes; ++body)
        if (bodyResidual(*problem_, trial_->net, body) > slack(body, ofOneBody * tolerance) &&
            !isDriven(*problem_, body))
            bodies.push_back(body);
    return bodies;
}

double Balance::sum() const {
    double sum = 0.0;
    for (int body = 0; body < problem_->blocks + problem_->nodes; ++body)
        if (!isDriven(*problem_, body)) sum += bodyResidual(*problem_, trial_->net, body);
    return sum;
}

double Balance::noiseOf(int body) const { return noise_.empty() ? 0.0 : noise_[body]; }

bool Balance::within(double tolerance) const { return residual_ <= tolerance && beyond_ <= 1.0; }

bool Balance::withinForces(const std::vector<double>& most) const {
    for (int block = 0; block < static_cast<int>(most.size()); ++block) {
        const double left = bodyResidual(*problem_, trial_->net, block);
        if (left > std::max(most[block], noiseOf(block)) && !isDriven(*problem_, block)) return false;
    }
    return true;
}

double Balance::slack(int body, double tolerance) const {
    const std::size_t at = body;
    const double passes = tolerance * forces_[at];
    const double may = problem_->mayLeave.empty() ? passes : std::min(passes, problem_->mayLeave[at]);
    return std::max(may, noiseOf(body));
}

}  // namespace keyblock
