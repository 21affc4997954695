// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy account. Each term is summed from the forces of its own element along
// their path. No term is calculated as the remainder of the others, so that the energy
// balance checks all of them (theory, "Energies").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/step/step_problem.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

/// Adds the energies of a dynamic step to the ledger before the step is accepted: the work of loads and prescribed
/// motions, the energy that the time scheme dissipates in links and blocks, and the energy dissipated by damping.
/// \param external the generalised loads of the step [N]; \param d the displacement over the step.
void accountStep(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& external,
              const Eigen::VectorXd& d, const StepOptions& options);

/// Energy account of a search for equilibrium, from the state in which the search began.
class StaticAccount {
public:
    StaticAccount(const Model& model, const State& start, const Loads& loads, const LoadPoint& before);

    /// Adds the work and the dissipation since the start to the energy ledger of `end`. Called before `end` is accepted.
    /// \param at the loads at `end`.
    /// \param moved the sum of the displacements along the path.
    /// \param problem the step built at `end`, from which `end` will be accepted; its `slipForce` receives the mean
    /// forces during sliding.
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
