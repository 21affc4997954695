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

/// Unbalanced forces of a trial and the forces with which they are compared. Keeps pointers to problem, rows and trial,
/// which must outlive it and must not change.
class Balance {
public:
    /// \param passes the number of iterations made so far. If it is 0, the round-off of inertia and loads is allowed
    /// for; if 1, no round-off; if 2 or more, the round-off of inertia, loads and links.
    /// \param tolerance the relative tolerance. After two or more iterations, round-off is estimated only if the trial
    /// exceeds this tolerance.
    Balance(const StepProblem& problem, const LinkRows& rows, const Trial& trial, int passes, double tolerance);

    /// Unbalanced force relative to the acting forces, for the bodies whose unbalanced force exceeds round-off.
    double residual() const { return residual_; }

    /// Body with the largest relative unbalanced force.
    int worst() const { return worst_; }

    /// True if, apart from round-off, the unbalanced force is at most `tolerance` times the acting forces and no body
    /// exceeds the unbalanced force allowed for it in a step at rest.
    bool within(double tolerance) const;

    /// Acceptable unbalanced force on a body [N].
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
