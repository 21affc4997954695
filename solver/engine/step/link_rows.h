// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gradients of all links in one array, for the loops over links that make up a
// step. Each link has twelve entries, six for each body. For a body with fewer
// unknowns, or none, the remaining entries are zero and are multiplied by the next
// body's unknowns or by the padding after the last one, so that no loop depends on the
// number of unknowns of a body.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <cstddef>
#include <vector>

namespace keyblock {

class LinkRows {
public:
    /// Number of extra entries at the end of a padded vector; they stay zero.
    static constexpr int padding = 6;

    explicit LinkRows(const StepProblem& problem);

    std::size_t count() const { return first_.size(); }

    /// Strain gradients of link i: six entries for body A, then six for body B.
    const double* gradient(std::size_t i) const { return &gradients_[12 * i]; }

    /// Index of the first unknown of body A (`firstOfA`) or body B (`firstOfB`) of link i in a padded vector.
    int firstOfA(std::size_t i) const { return first_[i].a; }
    int firstOfB(std::size_t i) const { return first_[i].b; }

    /// Norm of the generalised force on body A (`pullOnA`) or body B (`pullOnB`) per unit force of link i. Moments and
    /// strain terms are converted to forces with `StepProblem::weight`.
    double pullOnA(std::size_t i) const { return pulls_[i].a; }
    double pullOnB(std::size_t i) const { return pulls_[i].b; }

    /// Strain of link i at zero displacement.
    double start(std::size_t i) const { return start_[i]; }

    /// Strain increment of link i due to displacement `x` (padded).
    double rate(std::size_t i, const double* x) const {
        const double *g = gradient(i), *a = x + first_[i].a, *b = x + first_[i].b;
        double ofA = 0.0, ofB = 0.0;
        for (int k = 0; k < 6; ++k) ofA += g[k] * a[k];
        for (int k = 0; k < 6; ++k) ofB += g[6 + k] * b[k];
        return ofA + ofB;
    }

    /// Adds `force` times the gradient of link i to `sum` (padded).
    void add(std::size_t i, double force, double* sum) const {
        const double* g = gradient(i);
        double *a = sum + first_[i].a, *b = sum + first_[i].b;
        for (int k = 0; k < 6; ++k) a[k] += force * g[k];
        for (int k = 0; k < 6; ++k) b[k] += force * g[6 + k];
    }

    /// Strain increments of all links due to displacement `x` (padded), computed in parallel if there are many links.
    void rates(const Eigen::VectorXd& x, std::vector<double>& result) const;

    /// Strains of all links at displacement `d` (padded).
    void strains(const Eigen::VectorXd& d, std::vector<double>& result) const;

private:
    struct First {
        int a = 0, b = 0;
    };
    struct Pulls {
        double a = 0.0, b = 0.0;
    };
    std::vector<double> gradients_, start_;
    std::vector<First> first_;
    std::vector<Pulls> pulls_;
};

/// Add (`padded`) or remove (`unpadded`) the padding zeros at the end of a vector with one entry per unknown.
Eigen::VectorXd padded(const Eigen::VectorXd& x);
Eigen::VectorXd unpadded(const Eigen::VectorXd& x);

}  // namespace keyblock
