// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/anderson.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace keyblock {
namespace {

constexpr double astray = 2.0;  // over the change before: what was remembered says nothing about here
constexpr double regular = 1e-10;  // added to the diagonal of the normal equations, relative

}  // namespace

AndersonMixing::AndersonMixing(int remembered) : remembered_(remembered) {}

void AndersonMixing::remember(const Eigen::VectorXd& after, const Eigen::VectorXd& change) {
    if (changes_.rows() != after.size()) {
        changes_.resize(after.size(), remembered_);
        places_.resize(after.size(), remembered_);
        products_ = Eigen::MatrixXd::Zero(remembered_, remembered_);
    }
    newest_ = (newest_ + 1) % remembered_;
    kept_ = std::min(kept_ + 1, remembered_);
    changes_.col(newest_) = change - lastChange_;
    places_.col(newest_) = after - lastAfter_;
    for (int j = 0; j < kept_; ++j)
        products_(newest_, j) = products_(j, newest_) = changes_.col(newest_).dot(changes_.col(j));
}

bool AndersonMixing::mix(const std::vector<double>& before, std::vector<double>& after) {
    const auto n = static_cast<Eigen::Index>(after.size());
    const Eigen::VectorXd now = Eigen::Map<const Eigen::VectorXd>(after.data(), n);
    const Eigen::VectorXd change = now - Eigen::Map<const Eigen::VectorXd>(before.data(), n);
    const double size = change.norm();
    const bool restart = size > astray * lastSize_ || lastAfter_.size() != n;
    lastSize_ = size;
    if (restart) kept_ = 0, newest_ = -1;
    else remember(now, change);
    lastAfter_ = now;
    lastChange_ = change;
    if (kept_ == 0) return false;
    Eigen::MatrixXd normal = products_.topLeftCorner(kept_, kept_);
    normal.diagonal() *= 1.0 + regular;
    const Eigen::VectorXd weights = normal.ldlt().solve(changes_.leftCols(kept_).transpose() * change);
    if (!weights.allFinite()) return false;
    Eigen::Map<Eigen::VectorXd>(after.data(), n) -= places_.leftCols(kept_) * weights;
    return true;
}

}  // namespace keyblock
