// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares two runs of the same rock, as with and without bolts or with two designs of
// bolts: which blocks fall in one and are stable in the other, and which bolts hold them.
#pragma once

#include "solver/results/bolt_use.h"
#include "solver/results/run_source.h"
#include "solver/results/verdict.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// A block of both runs, found by its outline. The indices are those in the frames; for a block divided into cells,
/// that of its first cell.
struct SharedBlock {
    int a = -1, b = -1;
};

/// A bolt that holds a block in the run in which the block is stable.
struct HoldingBolt {
    int bolt = -1;
    double force = 0.0;  // net force of the bolt on block `on`, against its movement in the other run [N]
    int on = -1;  // the block itself, or a block next to it that fell with it and that the bolt holds directly
};

/// A block that is unstable in one run and stable in the other. A block that settled (`settledBlocks`) is stable.
struct SavedBlock {
    SharedBlock block;
    bool fallsInA = false;  // unstable in run a; otherwise in run b
    StageUnstable fall;  // in the run in which it is unstable
    double moved = 0.0;  // displacement in that run from its start to its last frame [m]; 0: not present there
    std::vector<HoldingBolt> heldBy;  // in the other run, largest force first; empty: no bolt
};

/// Displacements of a block from the start of each run to its last frame [m].
struct BlockDifference {
    SharedBlock block;
    Point a{0.0, 0.0}, b{0.0, 0.0};

    double size() const { return (a - b).norm(); }
};

/// A bolt of one or both runs, matched by name.
struct BoltDifference {
    std::string name;
    std::optional<BoltUse> a, b;  // none: not in this run
};

struct RunComparison {
    Verdict a, b;
    std::vector<int> settledA, settledB;  // blocks of the verdicts that came to rest near their positions
    std::size_t shared = 0, onlyA = 0, onlyB = 0;  // numbers of blocks
    std::vector<SavedBlock> saved;  // in the order of the verdicts
    std::vector<BlockDifference> blocks;  // shared blocks that are present at the end of both runs, largest first
    std::vector<BoltDifference> bolts;  // in the order of run a, then those of run b only
};

/// Compares two runs, finished or not. A run without frames has no displacements and no holding bolts.
RunComparison compareRuns(const RunSource& a, const RunSource& b);

/// Net force of a bolt on a block against a movement, above which the bolt is said to hold it, as a fraction of the
/// weight of the block.
inline constexpr double leastHoldingShare = 0.1;

}  // namespace keyblock
