// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks that were unstable in a stage and came to rest near their positions later in the
// run: a verdict lists them, but they did not fall.
#pragma once

#include "solver/results/run_source.h"
#include "solver/results/verdict.h"
#include "solver/scene/solved_blocks.h"

#include <optional>
#include <vector>

namespace keyblock {

/// Largest displacement over the whole run of a block that counts as settled, as a fraction of its size (distance from
/// its centroid to the farthest corner); as the default of `Until::move`.
inline constexpr double settledShare = 0.1;

/// Displacement of the centroid of a block from the start of the run to a frame [m]; none if the block is not present in
/// the frame. \param first index of the block or of its first cell.
std::optional<Point> wholeDisplacement(const Scene& scene, const SolvedBlocks& solved, const Frame& frame, int first);

/// The blocks of the verdict that are not unstable in the last stage that ended and that are no farther than
/// `settledShare` of their size from their positions at the start of the run. In the order of the verdict.
std::vector<int> settledBlocks(const RunSource& run, const Verdict& verdict);

}  // namespace keyblock
