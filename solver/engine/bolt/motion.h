// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the nodes of bolts move with a step.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Moves the nodes of all bolts by the step's displacement, turning them with the blocks that carry them.
/// \pre the blocks have not moved yet
void moveBolts(const Model& model, State& state, const Eigen::VectorXd& d);

}  // namespace keyblock
