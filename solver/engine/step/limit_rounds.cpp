// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/limit_rounds.h"

#include "solver/engine/step/friction_limits.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

constexpr std::size_t remembered = 6;  // rounds
constexpr int plainRounds = 3;  // most steps need no more

Law& limitedLaw(StepProblem& problem, const LimitPair& pair) {
    return problem.links[static_cast<std::size_t>(pair.limited)].law;
}

/// False for what is held as a preload.
bool follows(const Law& limited, const LimitPair& pair) {
    return limited.kind != LawKind::Constant || pair.rule == LimitPair::Rule::Push;
}

Eigen::VectorXd limitsOf(StepProblem& problem) {
    Eigen::VectorXd limits(static_cast<Eigen::Index>(problem.limitPairs.size()));
    Eigen::Index row = 0;
    for (const LimitPair& pair : problem.limitPairs) limits[row++] = limitedLaw(problem, pair).limit;
    return limits;
}

}  // namespace

void LimitRounds::correct(StepProblem& problem, const Eigen::VectorXd& d) {
    const Eigen::VectorXd used = limitsOf(problem);
    correctFrictionLimits(problem, d);
    Eigen::VectorXd allowed = limitsOf(problem);
    Eigen::VectorXd change = allowed - used;
    rounds_.push_back({std::move(allowed), std::move(change)});
    if (rounds_.size() > remembered) rounds_.pop_front();
    ++made_;
}

bool LimitRounds::mix(StepProblem& problem) {
    if (made_ <= plainRounds) return false;
    const auto earlier = static_cast<Eigen::Index>(rounds_.size()) - 1;
    const Round& last = rounds_.back();
    Eigen::MatrixXd changes(last.change.size(), earlier), steps(last.change.size(), earlier);
    for (Eigen::Index i = 0; i < earlier; ++i) {
        const Round &round = rounds_[static_cast<std::size_t>(i)], &next = rounds_[static_cast<std::size_t>(i) + 1];
        changes.col(i) = next.change - round.change;
        steps.col(i) = next.allowed - round.allowed;
    }
    const Eigen::VectorXd mixed = last.allowed - steps * changes.colPivHouseholderQr().solve(last.change);
    Eigen::Index row = 0;
    for (const LimitPair& pair : problem.limitPairs) {
        const double limit = std::max(pair.base, mixed[row++]);
        if (Law& limited = limitedLaw(problem, pair); follows(limited, pair)) limited.limit = limit;
    }
    return true;
}

}  // namespace keyblock
