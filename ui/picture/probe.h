// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is under the mouse, in words: the quantity that is shown first, then what
// else a person asks of a block or a bolt.
#pragma once

#include "ui/picture/pick.h"

#include <string>
#include <vector>

namespace keyblock {

struct ProbeReading {
    std::string head;  // "Block 143"
    std::vector<std::pair<std::string, std::string>> rows;  // what, how much with its unit
};

/// Of the frame that the picture shows, in the units and signs of the picture; of a block also its peak so far where that
/// is clearly beyond the present value. \param shownFirst of blocks and bolts; null: none.
ProbeReading probed(const SectionPicture& picture, const Frame& frame, const Pick& pick,
                    const FrameQuantity<BlockState>* blocksFirst, const FrameQuantity<BoltNodeFrame>* boltsFirst);

}  // namespace keyblock
