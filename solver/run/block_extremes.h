// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Extremes of blocks over a run. They are updated at every step, because a stress
// wave or an impact may pass a block between two frames.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// Updates the extremes of an active block with its state at `time` in `stage`.
void addExtreme(const BlockState& block, int stage, double time, BlockExtremes& extremes);

/// Resets the largest displacements of all blocks, for `zero_displacements`.
void forgetDisplacements(std::vector<BlockExtremes>& extremes);

}  // namespace keyblock
