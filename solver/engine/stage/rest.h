// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Test for equilibrium of the bodies. The unbalanced force of each block is compared
// with the block's own weight, because the other forces in a scene, even those on the
// block itself, may be a thousand times larger. An unsupported key block between walls
// under 25 MPa would otherwise be taken to be in equilibrium (theory, "Equilibrium").
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

#include <vector>

namespace keyblock {

/// Reference forces and round-off errors with which unbalanced forces are compared, one value per body [N].
struct RestForces {
    std::vector<double> own;  // block: weight, or without gravity its loads or other forces; node: sum of its forces
    std::vector<double> all;  // sum of the magnitudes of the forces of loads, links and stress
    std::vector<double> noise;  // round-off error due to the limited precision of the coordinates
    std::vector<double> outerNoise;  // round-off error without glue, which acts within a block
    bool weighs = false;  // gravity or a body acceleration acts
};

/// Reference forces of all bodies at rest in `state`.
/// \param problem a step from rest in `state`, with friction limits that match the forces in `state`.
/// \param weightPerMass the result of the function `weightPerMass` [m/s²]; 0: no gravity or body acceleration.
RestForces restForces(const Model& model, const State& state, const StepProblem& problem, double weightPerMass);

/// Largest round-off error, as a fraction of a block's weight, at which equilibrium of the block can still be decided.
inline constexpr double mostNoise = 0.02;

/// The body that is farthest from equilibrium, with lists of the bodies that are not in equilibrium or undecidable.
struct Unrest {
    int body = -1;  // −1: nothing is free to move
    double share = 0.0;  // unbalanced force over the reference force, scaled to the tolerance of blocks
    double force = 0.0;  // unbalanced force [N]
    double beyond = 0.0;  // unbalanced force over the allowed one, which is at least round-off; at most 1 at rest
    std::vector<int> restless;  // all bodies with a ratio above 1
    std::vector<int> undecidable;  // first rows of blocks whose round-off error exceeds `mostNoise` times their weight
    double noise = 0.0;  // largest round-off error of these over the weight
};

/// Finds the body that is farthest from equilibrium.
/// \param net the net force on every unknown at zero displacement, as returned by `netForce`.
/// \param share the unbalanced force allowed on a block, as a fraction of its weight.
Unrest farthestFromRest(const Model& model, const State& state, const StepProblem& problem, const RestForces& forces,
                        const Eigen::VectorXd& net, double share);

}  // namespace keyblock
