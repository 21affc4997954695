// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints and bolts that failed around the unstable blocks of a verdict.
#pragma once

#include "solver/results/verdict.h"

#include <vector>

namespace keyblock {

/// A joint between a block that the verdict lists as unstable and a block that is not unstable in the same stage. A
/// block divided into cells counts as one block.
struct FailedJoint {
    int stage = 0;
    int blockA = -1, blockB = -1;  // first rows; block a is the unstable one
    bool opened = false;  // the opening is at least as large as the slip
    double slip = 0.0, opening = 0.0;  // largest along the joint from the first to the last frame of the stage [m]
    Point position{0.0, 0.0};  // point of largest movement, in its position at the start of the stage [m]
};

/// A failed bolt between blocks that the verdict lists as unstable and other blocks. `Debonding` means that all bonds
/// of the bolt on one side of the joint have failed and that no face plate supports that side; `time` is then the time
/// of the last bond failure.
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
