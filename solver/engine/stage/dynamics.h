// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic stages: steps of one scheme of time integration. A step that does
// not settle, or whose energy does not balance, is cut and later grown again; one
// in which something reaches its limit ends there, and that is released before the next.
#pragma once

#include "solver/engine/stage/engine.h"
#include "solver/engine/time/time_scheme.h"

namespace keyblock {

struct DynamicSettings {
    Inertia scheme = Inertia::Shi;
    double timeStep = 1e-3;  // [s] the longest
    double rhoInf = 0.8;  // generalized-alpha
    Damping damping{};
};

/// What the next step takes over from the last ones.
struct DynamicPace {
    double dt = 0.0;  // to be tried next [s]; 0: the longest
    double lastMove = 0.0;  // of the last step [m]
    double roundedUp = 0.0;  // what the stage's time has too much [s]
    bool sweepsFirst = false;  // the last step took sweeps over the contact forces: the next may begin with them
};

/// Keeps nothing from step to step but its settings.
class DynamicStage {
public:
    DynamicStage(Engine& engine, const Loads& loads, std::function<LoadPoint(double)> loadsAt, DynamicSettings settings);

    /// Makes the state ready for the first step; no time passes. Touching blocks without history get contact forces
    /// and stresses that agree with the first accelerations, kept as preload (theory, "The start of a motion"); driven
    /// blocks get the velocity of their motion, and the scheme its accelerations.
    StepEnding begin(State& state);

    /// One accepted step from `time`, at most to `end`; `time` is moved on.
    StepEnding step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);

private:
    struct Trial {
        State state;
        double residual = 0.0;
        TakenStep taken;  // but for where it began
    };
    enum class Attempt { Settled, TooLong, Unbalanced, Stopped };
    Attempt attempt(const State& state, double time, double dt, DynamicPace& pace, Trial& trial);
    void drive(State& state) const;
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
