// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every single force on every block, as the engine balances it: of the links of a
// step, of its loads, of what is prescribed, and of inertia. Their sum on a block is
// what the engine left unbalanced there.
#pragma once

#include "solver/engine/stage/taken_step.h"

#include <vector>

namespace keyblock {

/// A force on a block, and the part that gives it. Forces that are 0 are not listed.
struct SingleForce {
    BlockForce force;  // its position counts from the block's centroid, where the step has it [m]
    int part = -1;  // row of the step's contacts, of the model's bonds, or an anchored one of all nodes; −1: else
};

/// Forces in a state at rest; of the blocks that do not move freely also the reaction, at their centroids.
std::vector<SingleForce> forcesAtRest(const Model& model, const State& state, const Loads& loads, const LoadPoint& at);

/// The same where a motion begins: inertia is what all other forces leave.
std::vector<SingleForce> forcesAtStart(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                       const Damping& damping);

/// Forces over a step in motion, inertia among them.
std::vector<SingleForce> forcesOver(const Model& model, const Loads& loads, const TakenStep& step);

}  // namespace keyblock
