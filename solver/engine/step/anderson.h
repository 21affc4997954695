// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anderson's mixing (1965) of a fixed-point iteration: from what the last rounds
// changed it takes the combination of them that would have changed least, as far as
// the change is linear.
#pragma once

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace keyblock {

class AndersonMixing {
public:
    explicit AndersonMixing(int remembered);

    /// Takes a round that changed its values by `change` to `after`, and sets `after` to where the next had best begin.
    /// \param linear what depends linearly on the values; it is combined as they are.
    /// \return false in the first round, and where the iteration went astray and begins again: nothing is set then.
    bool mix(const Eigen::VectorXd& change, std::vector<double>& after, Eigen::VectorXd& linear);

private:
    void remember(const Eigen::VectorXd& change, const Eigen::VectorXd& after, const Eigen::VectorXd& linear);
    void multiply(const Eigen::VectorXd& change);

    int remembered_;
    int kept_ = 0, newest_ = -1;  // differences of successive rounds: how many, and the column of the newest
    Eigen::MatrixXd changes_, places_, linear_;  // a column per difference: of the changes, and of where they led
    Eigen::MatrixXd products_;  // of the columns of `changes_` with each other
    Eigen::VectorXd withLast_;  // products of the same with the last change
    Eigen::VectorXd lastAfter_, lastChange_, lastLinear_;
    double lastSize_ = std::numeric_limits<double>::infinity();
};

}  // namespace keyblock
