// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values at the cursor: the quantity shown first, then other common quantities of a
// block or bolt.
#pragma once

#include "ui/picture/pick.h"

#include <string>
#include <vector>

namespace keyblock {

struct ProbeReading {
    std::string head;  // "Block 143"
    std::vector<std::pair<std::string, std::string>> rows;  // name, value with its unit
};

/// From the frame that the picture shows, in the units and signs of the picture; for a block also its peak so far if
/// it clearly exceeds the current value. \param shownFirst of blocks and bolts; null: none.
ProbeReading probed(const SectionPicture& picture, const Frame& frame, const Pick& pick,
                    const FrameQuantity<BlockState>* blocksFirst, const FrameQuantity<BoltNodeFrame>* boltsFirst);

}  // namespace keyblock
