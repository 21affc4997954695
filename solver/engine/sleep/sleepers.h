// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which blocks sleep. A block falls asleep after it has hardly moved for a number of
// steps, and wakes as soon as the force or moment on it has changed since then by more
// than the tolerance, or than what steps may leave on it (theory, "Sleep").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

#include <vector>

namespace keyblock {

/// Force (along and across the block's axis [N]) and moment [N m] per block.
using BlockForces = std::vector<Eigen::Vector3d>;

struct SleepLimits {
    double tolerance = 0.0;  // unbalanced force on a block at rest over its weight; 0: nothing sleeps
    double timeStep = 0.0;  // of the stage [s]
    double weight = 0.0;  // per unit mass, as `weightPerMass` [m/s²]; 0: nothing sleeps

    bool allow() const { return tolerance > 0.0 && weight > 0.0; }
};

bool anyAsleep(const State& state);

/// True if blocks sleep and no block or bolt moves with the steps.
bool isAllAsleep(const Model& model, const State& state);

/// Counts the steps in succession in which each block that is awake hardly moved: no faster than the speed that an
/// unbalanced force at the tolerance gives it in one step of the stage. Much shorter steps are not counted. A block is
/// not quiet while a bolt that crosses it moves faster.
/// \param d the displacement over the step, per unknown. \param dt the length of the step [s].
void countQuietSteps(const Model& model, const Eigen::VectorXd& d, double dt, const SleepLimits& limits, State& state);

/// Blocks that have been quiet long enough to fall asleep, of a block that is divided into cells all or none. Blocks
/// with a prescribed motion stay awake.
std::vector<char> mayFallAsleep(const Model& model, const Loads& loads, const State& state);

/// Lets those of the blocks `may` fall asleep on which the forces balance, to the tolerance of sleep or to what steps
/// may leave there, and the bolts that cross no other. Their kinetic energy counts as damped.
/// \param at the present loads. \return true if any fell asleep.
bool fallAsleep(const Model& model, const Loads& loads, const LoadPoint& at, const SleepLimits& limits,
                std::vector<char> may, State& state);

/// Forces of links on the sleeping blocks of a part of the scene, at the start of a step and at its end.
BlockForces linkForces(const Model& part, const StepProblem& problem);
BlockForces linkForces(const Model& part, const StepProblem& problem, const Eigen::VectorXd& d);

/// True if no force differs between two load points, whatever motions they prescribe.
bool isSameForce(const LoadPoint& a, const LoadPoint& b);

/// Change of the loads on sleeping blocks; empty if the loads are the same.
BlockForces loadChanges(const Model& model, const State& state, const Loads& loads, const LoadPoint& before,
                        const LoadPoint& after);

/// Wakes the blocks whose force has changed by more than the tolerance and than what steps may leave there, and the
/// sleeping blocks around them.
/// \param changes per block, since it fell asleep. \return true if any woke.
bool wakeDisturbed(const Model& model, const SleepLimits& limits, const BlockForces& changes, State& state);

void wakeAll(State& state);

/// Changes of the force on each block since it fell asleep; zero for blocks that are awake.
BlockForces changesOf(const State& state);
void setChanges(const BlockForces& changes, State& state);

}  // namespace keyblock
