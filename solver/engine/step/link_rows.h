// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gradients of all links side by side, for the sweeps over them that a step is
// made of. Every link has twelve entries, six for either body. A body with fewer
// unknowns, or none, has zeros, which meet the next body's unknowns or the padding
// behind the last one: no loop asks how wide a body is.
#pragma once

#include "solver/engine/step/step_problem.h"

#include <cstddef>
#include <vector>

namespace keyblock {

class LinkRows {
public:
    /// Unknowns that a padded vector has in excess of the problem's; they stay zero.
    static constexpr int padding = 6;

    explicit LinkRows(const StepProblem& problem);

    std::size_t count() const { return first_.size(); }

    /// Gradients of link i in its two bodies, six entries each.
    const double* gradient(std::size_t i) const { return &gradients_[12 * i]; }

    /// First unknowns of its two bodies.
    int firstOfA(std::size_t i) const { return first_[i].a; }
    int firstOfB(std::size_t i) const { return first_[i].b; }

    /// Force on either body per unit of the link's, moments and strains turned into forces by the problem's weights.
    double pullOnA(std::size_t i) const { return pulls_[i].a; }
    double pullOnB(std::size_t i) const { return pulls_[i].b; }

    /// Strain at no displacement.
    double start(std::size_t i) const { return start_[i]; }

    /// What displacement `x` (padded) adds to the strain of link i.
    double rate(std::size_t i, const double* x) const {
        const double *g = gradient(i), *a = x + first_[i].a, *b = x + first_[i].b;
        double ofA = 0.0, ofB = 0.0;
        for (int k = 0; k < 6; ++k) ofA += g[k] * a[k];
        for (int k = 0; k < 6; ++k) ofB += g[6 + k] * b[k];
        return ofA + ofB;
    }

    /// Adds `force` along the gradient of link i to `sum` (padded).
    void add(std::size_t i, double force, double* sum) const {
        const double* g = gradient(i);
        double *a = sum + first_[i].a, *b = sum + first_[i].b;
        for (int k = 0; k < 6; ++k) a[k] += force * g[k];
        for (int k = 0; k < 6; ++k) b[k] += force * g[6 + k];
    }

    /// Rates of all links for `x` (padded), on all threads where there are many.
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

/// A vector over the unknowns with zeros behind the last one, and back.
Eigen::VectorXd padded(const Eigen::VectorXd& x);
Eigen::VectorXd unpadded(const Eigen::VectorXd& x);

}  // namespace keyblock
