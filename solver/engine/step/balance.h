// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Unbalanced forces at a trial displacement, and the convergence test on them. The
// unbalanced force of each body is compared with the forces acting on that body,
// because it remains as a change of the body's velocity. In a step at rest it must
// also stay below an absolute limit per body, however large the acting forces are
// (theory, "Tolerance").
#pragma once

#include "solver/engine/step/trial.h"

namespace keyblock {

/// Unbalanced forces of a trial and the forces with which they are compared. `problem`, `rows` and `trial` must outlive
/// the object and must not change.
class Balance {
public:
    /// \param passes the number of iterations made so far. It determines which round-off errors are allowed for:
    /// before the first iteration those of inertia and loads, after one iteration none, after two or more those of
    /// inertia, loads and links.
    /// \param tolerance the relative tolerance. After two or more iterations, round-off is estimated only if the trial
    /// exceeds this tolerance.
    Balance(const StepProblem& problem, const LinkRows& rows, const Trial& trial, int passes, double tolerance);

    /// Unbalanced force relative to the acting forces. Bodies whose unbalanced force is within round-off count as
    /// balanced.
    double residual() const { return residual_; }

    /// Index of the body with the largest unbalanced force relative to the forces acting on it; −1 if no body is free.
    int worst() const { return worst_; }

    /// True if `residual()` is at most `tolerance` and, in a step at rest, no body exceeds the unbalanced force allowed
    /// for it (`StepProblem::mayLeave`), apart from round-off.
    bool within(double tolerance) const;

    /// True if the unbalanced force on no block exceeds `most` [N], one value per block, apart from round-off.
    bool withinForces(const std::vector<double>& most) const;

    /// Bodies whose unbalanced force, relative to the forces acting on it, is more than `share` of that of the worst body,
    /// in ascending order; without those balanced to within round-off.
    std::vector<int> worstBodies(double share) const;

    /// Bodies whose unbalanced force is more than is allowed for a single body, in ascending order. The step may be
    /// unbalanced as a whole without any.
    std::vector<int> unbalancedBodies(double tolerance) const;

    /// Sum of the unbalanced forces on all bodies [N].
    double sum() const;

    /// Largest unbalanced force that is acceptable on a body [N].
    double slack(int body, double tolerance) const;

private:
    void compareBodies();
    void addUpForces();
    void addUpNoise();
    double noiseOf(int body) const;

    const StepProblem* problem_;
    const LinkRows* rows_;
    const Trial* trial_;
    int passes_;
    std::vector<double> forces_, noise_;  // acting forces and round-off per body [N]; noise_ empty: not estimated
    double residual_ = 0.0;
    double beyond_ = 0.0;  // largest ratio of a body's unbalanced force to `mayLeave`
    int worst_ = -1;
};

}  // namespace keyblock
