// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every single force on the blocks of a frame, so that the equilibrium of a block can be
// checked by adding them up.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// All forces on the blocks of a frame, sorted by block and, for each block, in the order of `ForceSource`. Inactive
/// (excavated or removed) blocks have no forces. The list is empty if the frame stores no forces.
std::vector<BlockForce> blockForces(const Frame& frame);

/// Moment about `centre` of a force acting at the point `at`, counter-clockwise positive [N m].
double momentAbout(const Point& centre, const Point& at, const Point& force);

}  // namespace keyblock
