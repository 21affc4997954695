// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The extremes of blocks over a run. They are kept step by step, because a stress
// wave or an impact may pass a block between two frames.
#pragma once

#include "solver/results/results.h"

#include <vector>

namespace keyblock {

/// Takes a state of a block that is there into account.
void addExtreme(const BlockState& block, int stage, double time, BlockExtremes& extremes);

/// Displacements count from here on.
void forgetDisplacements(std::vector<BlockExtremes>& extremes);

}  // namespace keyblock
