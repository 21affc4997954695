// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The books of energy. Every term is summed from the forces of its own element
// over the way that it went, and none is what the others leave, so that the
// balance is a check of all of them (theory, "Energies").
#pragma once

#include "solver/engine/stage/step_build.h"

namespace keyblock {

/// Books a dynamic step before it is accepted: work of loads and drives, what laws and blocks lose to the scheme, and
/// damping. \param external generalised loads of the step [N].
void bookStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
              const Eigen::VectorXd& d, const StepOptions& options);

/// A search for equilibrium, booked from where it began.
class StaticBooks {
public:
    StaticBooks(const Model& model, const State& start, const Loads& loads, const LoadPoint& before);

    /// Books the way to `end` under `at`, before it is accepted by `problem`, which is built there.
    /// \param moved sum of the displacements on the way.
    void book(State& end, const LoadPoint& at, const Eigen::VectorXd& moved, StepProblem& problem) const;

private:
    struct Forces {
        Eigen::VectorXd external, net;
    };
    Forces forcesOf(StepProblem& problem, const State& state, const LoadPoint& at) const;
    StepProblem atStart(const State& end) const;
    bool isMet(const Link& link, const State& end) const;
    double trapeziumOfEnded(const State& end, const Eigen::VectorXd& moved) const;

    const Model& model_;
    const Loads& loads_;
    const LoadPoint& before_;
    State start_;
    Forces first_;
};

}  // namespace keyblock
