// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Movement of bolt nodes by a step.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Moves the nodes of all bolts by the step's displacement `d`, including the exact rotation of the blocks in which
/// they lie.
/// \pre the blocks have not been moved yet.
void moveBolts(const Model& model, State& state, const Eigen::VectorXd& d);

}  // namespace keyblock
