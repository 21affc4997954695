// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anderson mixing (1965) for a fixed-point iteration. It forms the linear combination
// of the last iterates whose residual would be smallest if the residual were linear
// in the iterate. Mixing only after every second iteration takes fewer iterations
// (Banerjee, Suryanarayana and Pask 2016) and half the work.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace keyblock {

class AndersonMixing {
public:
    /// \param remembered number of differences between successive iterates that are combined.
    explicit AndersonMixing(int remembered);

    /// Records an iteration. After every second one, at first after the third, the result is replaced by the mixed iterate
    /// from which the next iteration should start.
    /// \param change the change of the iterate in this iteration.
    /// \param after the iterate at the end of the iteration; receives the mixed iterate.
    /// \param linear quantities that depend linearly on the iterate; they are mixed with the same weights.
    /// \return false if nothing was mixed: after the other iterations, at a restart because the iteration diverged, or if
    /// the weights are not finite. `after` and `linear` are then unchanged.
    bool mix(const Eigen::VectorXd& change, std::vector<double>& after, Eigen::VectorXd& linear);

private:
    void store(const Eigen::VectorXd& change, const Eigen::VectorXd& after, const Eigen::VectorXd& linear);
    void multiplyNew();
    Eigen::VectorXd weights() const;

    int most_;  // number of iterations that are kept
    int kept_ = 0, newest_ = -1;  // number of iterations kept; column of the latest
    int unmixed_ = 0;  // iterations since the last mixing
    Eigen::MatrixXd changes_, places_,
        linear_;  // `change`, `after` and `linear` of the kept iterations, one per column
    Eigen::MatrixXd products_;  // scalar products of the columns of `changes_` with each other
    double lastSize_ = std::numeric_limits<double>::infinity();
};

}  // namespace keyblock
