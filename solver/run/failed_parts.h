// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints and bolts that failed around the unstable blocks of a verdict.
#pragma once

#include "solver/results/verdict.h"

#include <vector>

namespace keyblock {

/// A failed joint between a block that the verdict lists as unstable and a block that is not unstable in the same
/// stage. A block divided into cells counts as one block.
struct FailedJoint {
    int stage = 0;
    int blockA = -1, blockB = -1;  // indices in the frames (of the first cell); block a is the unstable one
    bool opened = false;  // the opening is at least as large as the slip
    double slip = 0.0, opening = 0.0;  // largest along the joint from the first to the last frame of the stage [m]
    Point position{0.0, 0.0};  // point of largest movement, in its position at the start of the stage [m]
};

/// A failed bolt that connects unstable blocks of the verdict to other blocks. `Debonding` means that all bonds of the
/// bolt in the unstable blocks, or all bonds in the other blocks, have failed and that no face plate supports that
/// side; `time` is then the time of the last of these bond failures.
struct FailedBolt {
    int bolt = -1;
    EventKind event = EventKind::BoltLoss;
    int stage = 0;
    double time = 0.0;  // within the stage
};

struct FailedParts {
    std::vector<FailedJoint> joints;  // without movements below a tenth of the largest joint movement of the block
    std::vector<FailedBolt> bolts;  // the first event of each kind for each bolt, in the order of the bolts
};

/// Finds the failed joints and bolts; both lists are empty if the verdict has no unstable block.
FailedParts failedParts(const RunSource& run, const Verdict& verdict);

}  // namespace keyblock
