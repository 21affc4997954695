// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gradients and laws of all links in flat arrays, for the loops over links that
// make up a step. A gradient has twelve entries, six for each body. For a body with
// fewer unknowns, or none, the remaining entries are zero and are multiplied by the
// next body's unknowns or by the padding after the last one, so that no loop depends
// on the number of unknowns of a body.
#pragma once

#include "solver/engine/step/flat_law.h"
#include "solver/engine/step/step_problem.h"

#include <cstddef>
#include <vector>

namespace keyblock {

class LinkRows {
public:
    /// Number of extra entries at the end of a padded vector; they stay zero.
    static constexpr int padding = 6;

    explicit LinkRows(const StepProblem& problem);

    std::size_t count() const { return start_.size(); }

    /// Strain gradients of link i: six entries for body A, then six for body B.
    const double* gradient(std::size_t i) const { return &gradients_[12 * i]; }

    /// Index of the first unknown of body A (`firstOfA`) or body B (`firstOfB`) of link i in a padded vector.
    int firstOfA(std::size_t i) const { return ends_[i].firstA; }
    int firstOfB(std::size_t i) const { return ends_[i].firstB; }

    /// Body A or B of link i; −1 if there is none.
    int bodyA(std::size_t i) const { return ends_[i].bodyA; }
    int bodyB(std::size_t i) const { return ends_[i].bodyB; }

    /// Law of link i. Limits that do not follow the previous link are those at the time of construction.
    const FlatLaw& law(std::size_t i) const { return laws_[i]; }

    /// Norm of the generalised force on body A (`pullOnA`) or body B (`pullOnB`) per unit force of link i. Moments and
    /// strain terms are converted to forces with `StepProblem::weight`.
    double pullOnA(std::size_t i) const { return ends_[i].pullA; }
    double pullOnB(std::size_t i) const { return ends_[i].pullB; }

    /// Strain of link i at zero displacement.
    double start(std::size_t i) const { return start_[i]; }

    /// Strain increment of link i due to displacement `x` (padded).
    double rate(std::size_t i, const double* x) const {
        const double *g = gradient(i), *a = x + ends_[i].firstA, *b = x + ends_[i].firstB;
        double ofA = 0.0, ofB = 0.0;
        for (int k = 0; k < 6; ++k) ofA += g[k] * a[k];
        for (int k = 0; k < 6; ++k) ofB += g[6 + k] * b[k];
        return ofA + ofB;
    }

    /// Adds `force` times the gradient of link i to `sum` (padded).
    void add(std::size_t i, double force, double* sum) const {
        const double* g = gradient(i);
        double *a = sum + ends_[i].firstA, *b = sum + ends_[i].firstB;
        for (int k = 0; k < 6; ++k) a[k] += force * g[k];
        for (int k = 0; k < 6; ++k) b[k] += force * g[6 + k];
    }

    /// Strain increments of all links due to displacement `x` (padded), computed in parallel if there are many links.
    void rates(const Eigen::VectorXd& x, std::vector<double>& result) const;

    /// Strains of all links at displacement `d` (padded).
    void strains(const Eigen::VectorXd& d, std::vector<double>& result) const;

private:
    struct Ends {
        int firstA = 0, firstB = 0, bodyA = -1, bodyB = -1;
        double pullA = 0.0, pullB = 0.0;
    };
    std::vector<double> gradients_, start_;
    std::vector<Ends> ends_;
    std::vector<FlatLaw> laws_;
};

/// Add (`padded`) or remove (`unpadded`) the padding zeros at the end of a vector with one entry per unknown.
Eigen::VectorXd padded(const Eigen::VectorXd& x);
Eigen::VectorXd unpadded(const Eigen::VectorXd& x);

}  // namespace keyblock
