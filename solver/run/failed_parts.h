// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which joints and bolts failed around the blocks that a verdict names.
#pragma once

#include "solver/results/verdict.h"

#include <vector>

namespace keyblock {

/// A joint between a block that the verdict names and one that does not move with it; cells of a block as one.
struct FailedJoint {
    int stage = 0;
    int blockA = -1, blockB = -1;  // first rows; a is the one that the verdict names
    bool opened = false;  // it opened by more than it slipped
    double slip = 0.0, opening = 0.0;  // largest along the joint over the stage [m]
    Point position{0.0, 0.0};  // where it moved most, when the stage began [m]
};

/// A bolt between the blocks that the verdict names and others. `Debonding`: all its bonds on one side of the joint
/// failed, at the time of the last of them, and no face plate holds that side.
struct FailedBolt {
    int bolt = -1;
    EventKind event = EventKind::BoltLoss;
    int stage = 0;
    double time = 0.0;  // within the stage
};

struct FailedParts {
    std::vector<FailedJoint> joints;  // that moved by a tenth of the block's largest joint movement or more
    std::vector<FailedBolt> bolts;  // each kind of event once per bolt, the first; in the order of the bolts
};

/// Empty where the verdict names no block.
FailedParts failedParts(const RunSource& run, const Verdict& verdict);

}  // namespace keyblock
