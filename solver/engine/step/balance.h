// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a trial displacement is from balance, and when that is near enough. Every
// body is judged by the forces that act on it, because what a step leaves unbalanced
// the body keeps as a change of its velocity; at rest also by what the step may leave
// on it, however large those forces are (theory, "Tolerance").
#pragma once

#include "solver/engine/step/trial.h"

namespace keyblock {

/// What does not balance at a trial, and what it is compared with. Looks at problem, rows and trial, which have to stay
/// as they are.
class Balance {
public:
    /// \param passes made so far: what is left may be round-off from the second on; before the first, only that of
    /// inertia and loads.
    /// \param tolerance of the forces at play: round-off is looked into only where more is left.
    Balance(const StepProblem& problem, const LinkRows& rows, const Trial& trial, int passes, double tolerance);

    /// What is unbalanced over the forces at play, of the bodies that are off by more than round-off.
    double residual() const { return residual_; }

    /// Body that is balanced worst.
    int worst() const { return worst_; }

    /// True where what is left is less than `tolerance` of the forces at play and no more than a step at rest may leave on
    /// any body, or round-off.
    bool within(double tolerance) const;

    /// Force that `within` lets pass on a body [N].
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
    std::vector<double> forces_, noise_;  // [N] per body; noise_ empty: not looked into
    double residual_ = 0.0;
    double beyond_ = 0.0;  // largest unbalanced force of a body over what the step may leave on it
    int worst_ = -1;
};

}  // namespace keyblock
