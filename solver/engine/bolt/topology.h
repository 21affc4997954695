// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The block in which each bolt node lies, and the node's tributary length there (theory,
// "Where a node is"; paper, Fig. 4). Both are determined from the current geometry, so
// that a node can pass through a gap into another block, or out of the rock.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Sets the block, tributary length and initial bond of every node of the active bolts, for the positions in the
/// original scene.
void placeBolts(const Model& model, State& state);

/// Sets the block, tributary length and initial bond of every node of one bolt, for the current positions of the
/// blocks.
void placeBoltNow(const Model& model, State& state, int bolt);

/// Updates the block and tributary length of every bolt node after the bodies have moved.
/// \return the largest change of a node's tributary length [m]; for an anchor law given per node, the change is 1 if
/// the node enters or leaves the rock.
double followBolts(const Model& model, State& state);

}  // namespace keyblock
