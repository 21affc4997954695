// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All individual forces on the blocks as they enter the equilibrium equations of a
// step: forces of links, loads, reactions of prescribed unknowns, and inertia. Their
// sum on a block is the unbalanced force that the engine left there.
#pragma once

#include "solver/engine/stage/taken_step.h"

#include <vector>

namespace keyblock {

/// A force on a block and the part that exerts it. The functions below omit zero forces.
struct SingleForce {
    BlockForce force;  // its position is relative to the block's centroid as used in the step [m]
    int part = -1;  // contact of the step, glued edge of the model, or bolt node among all nodes; −1: none of these
};

/// Forces on the blocks in a state at rest. A block with prescribed unknowns also has a reaction, which acts at its
/// centroid.
std::vector<SingleForce> forcesAtRest(const Model& model, const State& state, const Loads& loads, const LoadPoint& at);

/// Forces on the blocks at the start of a dynamic stage. The inertia force of a block balances its other forces.
std::vector<SingleForce> forcesAtStart(const Model& model, const State& state, const Loads& loads, const LoadPoint& at,
                                       const Damping& damping);

/// Forces on the blocks over a dynamic step, including inertia.
std::vector<SingleForce> forcesOver(const Model& model, const Loads& loads, const TakenStep& step);

}  // namespace keyblock
