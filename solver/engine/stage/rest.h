// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When bodies rest. Every block is judged by its own weight, because what else acts
// in a scene, and on the block itself, may be a thousand times as much: clamped
// between walls under 25 MPa, a key block that nothing carries would pass as balanced
// (theory, "Equilibrium").
#pragma once

#include "solver/engine/model/state.h"
#include "solver/engine/step/step_problem.h"

#include <vector>

namespace keyblock {

/// Forces that what is left unbalanced is compared with, a row per body [N].
struct RestForces {
    std::vector<double> own;  // weight of a block; without gravity its load, or what else acts on it; of a node all forces
    std::vector<double> all;  // summed forces of loads, links and stress
    std::vector<double> noise;  // that the digits of the coordinates leave
    std::vector<double> outerNoise;  // the same without glue, which acts within a block
    bool weighs = false;  // gravity or a body acceleration acts
};

/// \param weightPerMass of gravity and body acceleration (loads.h); 0: neither acts [m/s²].
/// \param problem of a step at rest from `state`, its friction limits those of the forces there.
RestForces restForces(const Model& model, const State& state, const StepProblem& problem, double weightPerMass);

/// Of a block's weight, what round-off may hide if rest is to mean anything.
inline constexpr double mostNoise = 0.02;

/// The body that is farthest from rest.
struct Unrest {
    int body = -1;  // −1: nothing is free to move
    double share = 0.0;  // unbalanced force over the block's weight, or what stands for it
    double force = 0.0;  // [N]
    double beyond = 0.0;  // over what may be left, round-off included: at rest to 1
    std::vector<int> restless;  // all bodies that are beyond it
    std::vector<int> undecidable;  // first rows of blocks of whose weight round-off hides more than `mostNoise`
    double noise = 0.0;  // of these, the largest share that it hides
};

/// \param net force on every unknown where nothing moves. \param share of its weight that may be unbalanced on a block.
Unrest farthestFromRest(const Model& model, const State& state, const StepProblem& problem, const RestForces& forces,
                        const Eigen::VectorXd& net, double share);

}  // namespace keyblock
