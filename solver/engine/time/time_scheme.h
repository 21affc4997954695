// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time integration schemes. Each scheme is described by four linear combinations of
// displacement, velocity and acceleration, for the inertia force, the new velocity, the
// new acceleration and the damped velocity, and by the force over the step that it uses
// for each law. The step itself does not depend on the scheme (theory, "Time").
#pragma once

#include "solver/engine/laws/step_law.h"
#include "solver/engine/model/step_move.h"
#include "solver/scene/scene.h"

namespace keyblock {

struct StepProblem;

enum class Inertia {
    None,  // no time step: forces at the current positions and velocities
    Static,  // 2M/Δt² from rest, as a regularisation
    Shi,  // v⁺ = 2D/Δt − v, forces at the end of the step
    BackwardEuler,  // v⁺ = D/Δt, forces at the end of the step
    Newmark,  // v⁺ as in Shi, mean forces over the step
    GeneralizedAlpha  // forces and accelerations between start and end (Chung and Hulbert 1993)
};

struct StepOptions {
    Inertia inertia = Inertia::Static;
    double dt = 1.0;  // [s]
    bool frictionLocked = false;  // prevents sliding
    double rhoInf = 1.0;  // for GeneralizedAlpha: spectral radius at infinite frequency
    Damping damping{};  // dynamic schemes only
    const Eigen::VectorXd* path = nullptr;  // displacement over the step if already known
    const Eigen::VectorXd* cellPath = nullptr;  // displacement for the glue of cells; null: predicted from velocities
};

/// Linear combination d·D + v·(velocity) + a·(acceleration), where D is the displacement over the step. The velocity
/// and acceleration are taken at the start of the step.
struct Combination {
    double d = 0.0, v = 0.0, a = 0.0;
};

/// Coefficients of a time scheme for one time step.
struct SchemeFactors {
    Combination inertia;  // inertia force, to be multiplied by M
    Combination velocity;  // at the end of the step
    Combination acceleration;  // at the end of the step; GeneralizedAlpha only
    Combination rate;  // velocity on which damping acts
    StepRule rule;  // rule for the forces of links
    double contactShare = 1.0;  // weight of contact forces relative to the other forces
    double elastic = 1.0;  // fraction of D at which block stresses are evaluated
    double loadTime = 1.0;  // fraction of the step at which loads are evaluated
    double armTime = 0.5;  // fraction of the step at which directions and lever arms of forces on blocks are evaluated
};
SchemeFactors factorsOf(const StepOptions& options);

/// Prediction of the displacements over a step with these options, and the fraction of the step at which forces act.
StepMove moveOf(const StepOptions& options);

/// True for schemes with numerical dissipation: they remove kinetic energy even if no force does work.
bool losesMotion(Inertia inertia);

/// True for schemes that carry accelerations from step to step.
bool carriesAccelerations(Inertia inertia);

/// Inertia force on every unknown at displacement `d` [N].
Eigen::VectorXd inertiaForce(const Model& model, const State& state, const SchemeFactors& factors,
                             const Eigen::VectorXd& d);

/// Sets the velocities of all bodies at the end of the step. The velocity of a prescribed unknown is its displacement
/// in `d` divided by the time step. The work that accelerates bodies with prescribed unknowns and the energy dissipated
/// by the scheme are added to the energy balance.
void moveOn(const Model& model, State& state, const StepProblem& problem, const Eigen::VectorXd& d,
            const StepOptions& options);

}  // namespace keyblock
