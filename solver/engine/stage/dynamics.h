// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic stages: time steps of one integration scheme. If a step does not converge or
// its energy balance is not satisfied, the time step is reduced and later increased
// again. A step in which a limit is reached ends at that moment, and the part is
// released before the next step.
#pragma once

#include "solver/engine/stage/dynamic_pace.h"
#include "solver/engine/stage/engine.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

struct DynamicSettings {
    Inertia scheme = Inertia::Shi;
    double timeStep = 1e-3;  // maximum time step [s]
    double rhoInf = 0.8;  // spectral radius at infinite frequency, generalized-α only
    Damping damping{};
};

/// A step that was solved but has not been accepted yet.
struct FoundStep {
    State state;  // at the end of the step, before anything is released
    double residual = 0.0;
    TakenStep taken;  // without `before`
    double dt = 0.0;  // length of the step [s]
    bool atLimit = false;  // the step ends where a limit is reached
};

/// Integrates a dynamic stage step by step. Everything that a step takes over from earlier steps is in the state and in
/// `DynamicPace`.
class DynamicStage {
public:
    DynamicStage(Engine& engine, const Loads& loads, std::function<LoadPoint(double)> loadsAt, DynamicSettings settings);

    /// Prepares the state for the first step without advancing time. If any touching contact carries no force yet,
    /// contact forces and block stresses that are consistent with the initial accelerations are stored as preload
    /// (theory, "The start of a motion"). Blocks with a prescribed motion get the velocity of that motion. Initial
    /// accelerations are calculated if the time scheme uses them.
    /// \param inMotion the stage continues the motion of another one: forces stay as they are, without preload.
    StepEnding begin(State& state, bool inMotion = false);

    /// Advances the state by one accepted step, which ends at the time `end` [s] at the latest, and updates `time` [s].
    StepEnding step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);

    /// The two halves of `step`. `find` solves the step and leaves the state as it is; `take` accepts the result,
    /// releases what has reached its limit and reports the events.
    StepEnding find(const State& state, double time, double end, DynamicPace& pace, FoundStep& found);
    void take(FoundStep found, State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);

    /// Gives the bodies for which `chosen` is true the accelerations that all forces except contacts give them at `time`
    /// [s], if the time scheme uses accelerations. \param chosen per body: blocks first, then bolt nodes.
    void setAccelerations(State& state, double time, const std::vector<char>& chosen) const;

    /// Largest distance within which a step of length `dt` [s] looks for contacts [m], as far as the velocities and the
    /// last displacement in `pace` tell.
    double searchRange(const State& state, double dt, const DynamicPace& pace) const;

private:
    enum class Attempt { Settled, TooLong, Unbalanced, Stopped };
    Attempt attempt(const State& state, double time, double dt, DynamicPace& pace, FoundStep& trial);
    void drive(State& state) const;
    Eigen::VectorXd accelerationsAt(const State& state, double time, const Damping& damping) const;
    Eigen::VectorXd heldAccelerations(const State& state) const;
    void forget(const Eigen::VectorXd& held, State& state) const;
    LoadPoint loadsOver(double time, double dt, double share) const;
    double predictedMove(const State& state, double dt, const DynamicPace& pace) const;

    Engine& engine_;
    const Loads& loads_;
    std::function<LoadPoint(double)> loadsAt_;
    DynamicSettings settings_;
    int worst_ = -1;
};

}  // namespace keyblock
