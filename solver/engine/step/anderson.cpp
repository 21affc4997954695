// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/anderson.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace keyblock {
namespace {

constexpr double changedAstray = 2.0;  // times the previous change: the stored iterates are then of no use
constexpr double regular = 1e-10;  // relative increase of the diagonal of the normal equations

}  // namespace

AndersonMixing::AndersonMixing(int remembered) : remembered_(remembered) {}

void AndersonMixing::remember(const Eigen::VectorXd& change, const Eigen::VectorXd& after,
                              const Eigen::VectorXd& linear) {
    if (changes_.rows() != after.size()) {
        changes_.resize(after.size(), remembered_);
        places_.resize(after.size(), remembered_);
        linear_.resize(linear.size(), remembered_);
        products_ = Eigen::MatrixXd::Zero(remembered_, remembered_);
        withLast_ = Eigen::VectorXd::Zero(remembered_);
    }
    newest_ = (newest_ + 1) % remembered_;
    kept_ = std::min(kept_ + 1, remembered_);
    changes_.col(newest_) = change - lastChange_;
    places_.col(newest_) = after - lastAfter_;
    linear_.col(newest_) = linear - lastLinear_;
}

/// Multiplies the stored columns by the change. The differences from the products with the previous change are the
/// products with the newest column.
void AndersonMixing::multiply(const Eigen::VectorXd& change) {
    const Eigen::VectorXd now = changes_.leftCols(kept_).transpose() * change;
    for (int j = 0; j < kept_; ++j) products_(newest_, j) = products_(j, newest_) = now[j] - withLast_[j];
    products_(newest_, newest_) = changes_.col(newest_).squaredNorm();
    withLast_.head(kept_) = now;
}

bool AndersonMixing::mix(const Eigen::VectorXd& change, std::vector<double>& after, Eigen::VectorXd& linear) {
    Eigen::Map<Eigen::VectorXd> now(after.data(), static_cast<Eigen::Index>(after.size()));
    const double size = change.norm();
    const bool restart = size > changedAstray * lastSize_ || lastAfter_.size() != now.size();
    lastSize_ = size;
    if (restart) kept_ = 0, newest_ = -1;
    else remember(change, now, linear);
    lastAfter_ = now;
    lastChange_ = change;
    lastLinear_ = linear;
    if (kept_ == 0) return false;
    multiply(change);
    Eigen::MatrixXd normal = products_.topLeftCorner(kept_, kept_);
    normal.diagonal() *= 1.0 + regular;
    const Eigen::VectorXd weights = normal.ldlt().solve(withLast_.head(kept_));
    if (!weights.allFinite()) return false;
    now.noalias() -= places_.leftCols(kept_) * weights;
    linear.noalias() -= linear_.leftCols(kept_) * weights;
    return true;
}

}  // namespace keyblock
