// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/anderson.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace keyblock {
namespace {

constexpr double changedAstray = 2.0;  // times the previous change: the stored iterations are then of no use
// increase of the diagonal of the normal equations: relative to it, and to the products from whose differences it follows
constexpr double regular = 1e-10, roundingShare = 1e-15;
constexpr int beforeFirst = 3, between = 2;  // iterations before the first mixing, and between two of them

}  // namespace

AndersonMixing::AndersonMixing(int remembered) : most_(remembered + 1) {}

void AndersonMixing::store(const Eigen::VectorXd& change, const Eigen::VectorXd& after, const Eigen::VectorXd& linear) {
    if (changes_.rows() != after.size()) {
        changes_.resize(after.size(), most_);
        places_.resize(after.size(), most_);
        linear_.resize(linear.size(), most_);
        products_.resize(most_, most_);
    }
    newest_ = (newest_ + 1) % most_;
    kept_ = std::min(kept_ + 1, most_);
    ++unmixed_;
    changes_.col(newest_) = change;
    places_.col(newest_) = after;
    linear_.col(newest_) = linear;
}

/// Multiplies the changes since the last mixing by all that are kept.
void AndersonMixing::multiplyNew() {
    for (int back = unmixed_ - 1; back >= 0; --back) {
        const int column = (newest_ + most_ - back) % most_;
        products_.col(column).head(kept_).noalias() = changes_.leftCols(kept_).transpose() * changes_.col(column);
        products_.row(column).head(kept_) = products_.col(column).head(kept_).transpose();
    }
}

/// Weights of the columns, with a sum of 1, for which the sum of the weighted changes is smallest. They follow from the
/// differences of successive changes.
Eigen::VectorXd AndersonMixing::weights() const {
    const auto column = [&](int i) { return (newest_ + 1 + most_ - kept_ + i) % most_; };  // by age
    const auto product = [&](int i, int j) { return products_(column(i), column(j)); };
    const int n = kept_ - 1;
    Eigen::MatrixXd normal(n, n);
    Eigen::VectorXd right(n);
    for (int i = 0; i < n; ++i) {
        right[i] = product(i + 1, n) - product(i, n);
        for (int j = 0; j < n; ++j)
            normal(i, j) = product(i + 1, j + 1) - product(i + 1, j) - product(i, j + 1) + product(i, j);
    }
    for (int i = 0; i < n; ++i) normal(i, i) += regular * normal(i, i) + roundingShare * product(i, i);
    const Eigen::VectorXd shares = normal.ldlt().solve(right);
    Eigen::VectorXd result = Eigen::VectorXd::Zero(kept_);
    result[column(n)] = 1.0;
    for (int i = 0; i < n; ++i) {
        result[column(i + 1)] -= shares[i];
        result[column(i)] += shares[i];
    }
    return result;
}

bool AndersonMixing::mix(const Eigen::VectorXd& change, std::vector<double>& after, Eigen::VectorXd& linear) {
    Eigen::Map<Eigen::VectorXd> now(after.data(), static_cast<Eigen::Index>(after.size()));
    const double size = change.norm();
    if (size > changedAstray * lastSize_ || changes_.rows() != change.size()) kept_ = unmixed_ = 0, newest_ = -1;
    lastSize_ = size;
    store(change, now, linear);
    if (unmixed_ < (unmixed_ == kept_ ? beforeFirst : between)) return false;
    multiplyNew();
    unmixed_ = 0;
    const Eigen::VectorXd weight = weights();
    if (!weight.allFinite()) return false;
    now.noalias() = places_.leftCols(kept_) * weight;
    linear.noalias() = linear_.leftCols(kept_) * weight;
    return true;
}

}  // namespace keyblock
