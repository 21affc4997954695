// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy account. Every term is summed from the forces of its own element
// along its path, and none is the remainder of the others, so that the balance is a
// check of all of them (theory, "Energies").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

/// Accounts for a dynamic step before it is accepted: work of loads and drives, what laws and blocks lose to the
/// scheme, and damping. \param external generalised loads of the step [N].
void accountStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
              const Eigen::VectorXd& d, const StepOptions& options);

/// The energy of a search for equilibrium, from where it began.
class StaticAccount {
public:
    StaticAccount(const Model& model, const State& start, const Loads& loads, const LoadPoint& before);

    /// Adds the path to `end` under `at` to its ledger, before it is accepted by `problem`, which is built there.
    /// \param moved sum of the displacements along it.
    void add(State& end, const LoadPoint& at, const Eigen::VectorXd& moved, StepProblem& problem) const;

private:
    struct Forces {
        Eigen::VectorXd external, net;
    };
    Forces forcesOf(StepProblem& problem, const State& state, const LoadPoint& at) const;
    StepProblem atStart(const State& end) const;
    const Contact* contactAtStart(const Link& link, const State& end) const;
    double trapeziumOfEnded(const State& end, const Eigen::VectorXd& moved) const;
    void addBodies(EnergyLedger& energy, const Forces& last, const Eigen::VectorXd& moved,
                   const StepProblem& problem) const;

    const Model& model_;
    const Loads& loads_;
    const LoadPoint& before_;
    State start_;
    Forces first_;
};

}  // namespace keyblock
