// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which block each node of a bolt is in, and its tributary length there (theory,
// "Where a node is"; paper, Fig. 4). Found afresh from the geometry, so that a node
// can pass through a gap into another block, and out.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Blocks, tributary lengths and first bonds of every node of the bolts that are present, where the scene has them.
void placeBolts(const Model& model, State& state);

/// The same for one bolt, by the blocks as they are now.
void placeBoltNow(const Model& model, State& state, int bolt);

/// Blocks and tributary lengths after the bodies moved.
/// \return the largest change of a node's tributary length [m, or 1 per node].
double followBolts(const Model& model, State& state);

}  // namespace keyblock
