// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anderson mixing (1965) for a fixed-point iteration. It forms the linear combination
// of the last iterates whose residual would be smallest if the residual were linear
// in the iterate.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace keyblock {

class AndersonMixing {
public:
    explicit AndersonMixing(int remembered);

    /// Records an iteration and replaces its result by the mixed iterate from which the next iteration should start.
    /// \param change the change of the iterate in this iteration.
    /// \param after the iterate at the end of the iteration; receives the mixed iterate.
    /// \param linear quantities that depend linearly on the iterate; they are mixed with the same weights.
    /// \return false if nothing was mixed: in the first iteration, at a restart because the iteration diverged, or if
    /// the weights are not finite. `after` and `linear` are then unchanged.
    bool mix(const Eigen::VectorXd& change, std::vector<double>& after, Eigen::VectorXd& linear);

private:
    void remember(const Eigen::VectorXd& change, const Eigen::VectorXd& after, const Eigen::VectorXd& linear);
    void multiply(const Eigen::VectorXd& change);

    int remembered_;
    int kept_ = 0, newest_ = -1;  // number of stored differences of successive iterations; column of the latest
    Eigen::MatrixXd changes_, places_, linear_;  // differences of `change`, `after` and `linear`, one per column
    Eigen::MatrixXd products_;  // scalar products of the columns of `changes_` with each other
    Eigen::VectorXd withLast_;  // scalar products of the columns of `changes_` with the last change
    Eigen::VectorXd lastAfter_, lastChange_, lastLinear_;
    double lastSize_ = std::numeric_limits<double>::infinity();
};

}  // namespace keyblock
