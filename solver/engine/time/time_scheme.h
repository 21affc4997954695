// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The schemes of time integration. Each says in four sums of displacement,
// velocity and acceleration what it makes of inertia, of the new motion and of
// damping, and which force of a law it takes; the step knows no scheme by name
// (theory, "Time").
#pragma once

#include "solver/engine/laws/step_law.h"
#include "solver/engine/model/step_move.h"
#include "solver/scene/scene.h"

namespace keyblock {

struct StepProblem;

enum class Inertia {
    None,  // forces where the bodies are and as they move, no step
    Static,  // 2M/Δt² about rest: a regularisation
    Shi,  // v⁺ = 2D/Δt − v, forces at the end
    BackwardEuler,  // v⁺ = D/Δt, forces at the end
    Newmark,  // as Shi, mean forces
    GeneralizedAlpha  // forces and accelerations between start and end (Chung and Hulbert 1993)
};

struct StepOptions {
    Inertia inertia = Inertia::Static;
    double dt = 1.0;  // [s]
    bool frictionLocked = false;
    double rhoInf = 1.0;  // GeneralizedAlpha: spectral radius of modes much stiffer than the step
    Damping damping{};  // dynamic schemes only
    const Eigen::VectorXd* path = nullptr;  // displacement over the step, where it is known already
    const Eigen::VectorXd* cellPath = nullptr;  // the same for the glue of cells; null: predicted from velocities
};

/// d·D + v·(velocity) + a·(acceleration) at the step's start.
struct Combination {
    double d = 0.0, v = 0.0, a = 0.0;
};

/// A scheme at one length of step.
struct SchemeFactors {
    Combination inertia;  // times M: force of inertia
    Combination velocity;  // at the end
    Combination acceleration;  // at the end; GeneralizedAlpha only
    Combination rate;  // the velocity that damping resists
    StepRule rule;  // of the links
    double contactShare = 1.0;  // of contacts in the step's balance
    double elastic = 1.0;  // share of D at which the stress of blocks is taken
    double loadTime = 1.0;  // share of the step at which loads are taken
    double armTime = 0.5;  // share of the step at which forces on points of blocks take their direction and lever arm
};
SchemeFactors factorsOf(const StepOptions& options);

/// How far the bodies are known to move in a step, and where on the way forces act on them.
StepMove moveOf(const StepOptions& options);

/// True for the schemes that lose kinetic energy beyond the work of their forces.
bool losesMotion(Inertia inertia);

/// True for the schemes that carry accelerations from step to step.
bool carriesAccelerations(Inertia inertia);

/// Inertia force on every unknown at displacement `d` [N].
Eigen::VectorXd inertiaForce(const Model& model, const State& state, const SchemeFactors& factors,
                             const Eigen::VectorXd& d);

/// Gives every body its velocity at the end of the step and accounts for what moves the driven ones and for what
/// the scheme itself dissipates. A prescribed unknown moves at D/Δt.
void moveOn(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d,
            const StepOptions& options);

}  // namespace keyblock
