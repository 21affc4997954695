// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic stages: steps of Shi's scheme or of backward Euler. A step that does
// not settle is cut and later grown again; one in which something reaches its
// limit ends there, and that lets go before the next.
#pragma once

#include "solver/engine/engine.h"

namespace keyblock {

struct DynamicSettings {
    Inertia scheme = Inertia::Shi;
    double timeStep = 1e-3;  // [s] the longest
};

class DynamicStage {
public:
    DynamicStage(Engine& engine, const Loads& loads, std::function<LoadPoint(double)> loadsAt, DynamicSettings settings);

    /// Finds contact forces and stresses consistent with the first accelerations and keeps them as
    /// preload, where blocks touch without history; no time passes (theory, "The start of a motion").
    StepEnding preload(State& state);

    /// One accepted step from `time`, at most to `end`; `time` is moved on.
    StepEnding step(State& state, double& time, double end, StepObserver& observer);

private:
    struct Trial {
        State state;
        double residual = 0.0;
    };
    enum class Attempt { Settled, TooLong, Stopped };
    Attempt attempt(const State& state, double time, double dt, Trial& trial);
    double predictedMove(const State& state, double dt) const;

    Engine& engine_;
    const Loads& loads_;
    std::function<LoadPoint(double)> loadsAt_;
    DynamicSettings settings_;
    double dt_;
    double lastMove_ = 0.0;
    int worst_ = -1;
};

}  // namespace keyblock
