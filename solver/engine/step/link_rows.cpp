// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/link_rows.h"

#include "solver/engine/step/parallel.h"

#include <cmath>

namespace keyblock {
namespace {

constexpr std::size_t linksATask = 4096;

}  // namespace

LinkRows::LinkRows(const StepProblem& problem)
    : gradients_(12 * problem.links.size(), 0.0), start_(problem.links.size()), ends_(problem.links.size()) {
    const Eigen::VectorXd weight = padded(problem.weight);
    const auto pull = [&](const double* g, int first) {
        double sum = 0.0;
        for (int k = 0; k < 6; ++k) sum += g[k] * g[k] * weight[first + k] * weight[first + k];
        return std::sqrt(sum);
    };
    for (std::size_t i = 0; i < count(); ++i) {
        const Link& link = problem.links[i];
        start_[i] = link.strain + link.shift;
        const int firstA = problem.first(link.a), firstB = link.b >= 0 ? problem.first(link.b) : problem.unknowns();
        for (int k = 0; k < problem.width(link.a); ++k) gradients_[12 * i + k] = link.ga[k];
        for (int k = 0; link.b >= 0 && k < problem.width(link.b); ++k) gradients_[12 * i + 6 + k] = link.gb[k];
        ends_[i] = {firstA, firstB, link.a, link.b, pull(gradient(i), firstA), pull(gradient(i) + 6, firstB)};
    }
    laws_.reserve(count());
    for (const Link& link : problem.links) laws_.push_back(flatLaw(problem, link));
    for (const LimitPair& pair : problem.limitPairs) {
        const FlatBounds& from = laws_[pair.from].bounds;
        FlatBounds& bounds = (laws_[pair.limited] = flatLaw(problem, pair)).bounds;
        bounds.bent = bounds.bent || from.bent || from.yields || from.follows;
    }
}

void LinkRows::rates(const Eigen::VectorXd& x, std::vector<double>& result) const {
    result.resize(count());
    forEach(count(), linksATask, [&](std::size_t i) { result[i] = rate(i, x.data()); });
}

void LinkRows::strains(const Eigen::VectorXd& d, std::vector<double>& result) const {
    result.resize(count());
    if (d.isZero(0.0)) {
        for (std::size_t i = 0; i < count(); ++i) result[i] = start_[i] + 0.0;  // no negative zeros, as below
        return;
    }
    forEach(count(), linksATask, [&](std::size_t i) { result[i] = start_[i] + rate(i, d.data()); });
}

Eigen::VectorXd padded(const Eigen::VectorXd& x) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(x.size() + LinkRows::padding);
    result.head(x.size()) = x;
    return result;
}

Eigen::VectorXd unpadded(const Eigen::VectorXd& x) { return x.head(x.size() - LinkRows::padding); }

}  // namespace keyblock
