// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every single force on the blocks of a frame, so that the balance of a block can be
// checked by adding them up.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// All forces on the blocks of a frame, block by block, those of one block in the order of `ForceSource`; none of blocks
/// that are not there. Empty where the frame has kept none.
std::vector<BlockForce> blockForces(const Frame& frame);

/// Moment about `centre` of a force that acts at `at`, counter-clockwise positive [N m].
double momentAbout(const Point& centre, const Point& at, const Point& force);

}  // namespace keyblock
