// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dynamic steps in which blocks at rest are left out. As long as everything is awake,
// the step is that of the whole scene; otherwise it is a step of the part that is awake
// (scene_part), repeated if it would disturb a sleeping block.
#pragma once

#include "solver/engine/sleep/scene_part.h"
#include "solver/engine/sleep/sleepers.h"
#include "solver/engine/stage/dynamics.h"

#include <memory>
#include <optional>

namespace keyblock {

/// What steps of a part reuse from step to step. It is derived from the state and can be dropped between two steps.
struct PartInUse {
    ScenePart part;
    Engine engine;
    LoadPoint at;  // loads of the whole scene in the last step
    /// Per block of the part that sleeps: the forces of its links when it fell asleep. If it had other links then, the
    /// present forces minus their change since.
    BlockForces before;

    PartInUse(const Model& whole, const State& state, const Loads& loads, double reach)
        : part(whole, state, loads, reach), engine(part.model()) {}
};

class SleepingStage {
public:
    /// \param part owned by the caller and passed on from step to step; empty at first.
    /// \param tolerance the unbalanced force on a sleeping block over its weight; 0: nothing sleeps.
    SleepingStage(Engine& engine, std::unique_ptr<PartInUse>& part, const Loads& loads,
                  std::function<LoadPoint(double)> loadsAt, const DynamicSettings& settings, double tolerance);

    /// As in `DynamicStage`. \pre in `begin`, every block is awake.
    StepEnding begin(State& state, bool inMotion);
    StepEnding step(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);

private:
    void fallAsleepAt(double time, State& state);
    void wakeAllAt(double time, State& state) const;
    bool wakeDisturbedAt(double time, double dt, const BlockForces& changes, State& state) const;
    void startMoving(const std::vector<char>& slept, double time, State& state) const;
    StepEnding stepOfWhole(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);
    StepEnding stepOfPart(State& state, double& time, double end, DynamicPace& pace, StepObserver& observer);
    bool staysAsleep(const State& state, double time, double dt) const;
    void pass(State& state, double& time, double end, DynamicPace& pace) const;
    void prepare(const State& state, double time, double dt, const DynamicPace& pace);
    DynamicStage partStage() const;
    StepEnding find(const State& own, double time, double end, DynamicPace& pace, FoundStep& found);
    void take(FoundStep found, State& state, State own, double& time, double end, DynamicPace& pace,
              StepObserver& observer);
    void count(const Engine& engine, double dt, double time, State& state) const;
    SleepLimits limitsAt(double time) const;

    Engine& engine_;
    std::unique_ptr<PartInUse>& part_;
    const Loads& loads_;
    std::function<LoadPoint(double)> loadsAt_;
    DynamicSettings settings_;
    DynamicStage whole_;
    double tolerance_;
};

/// The state before the last accepted step if that step led to `now`.
std::optional<State> stateBefore(const Engine& engine, const PartInUse* part, const State& now);

/// The last accepted step if it led to `now`, as a step of the whole scene, whether a part of it or all was awake.
std::optional<TakenStep> lastStep(const Engine& engine, const PartInUse* part, const Loads& loads, const State& now);

}  // namespace keyblock
