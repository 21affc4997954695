// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values at the cursor: the quantity currently displayed first, then other common
// quantities of the block or bolt.
#pragma once

#include "ui/picture/section/pick.h"

#include <string>
#include <vector>

namespace keyblock {

struct ProbeReading {
    std::string head;  // "Block 143"
    std::vector<std::pair<std::string, std::string>> rows;  // name, and value with its unit
};

/// Values of the picked object in `frame`, with the units and sign conventions of `picture`. For a block, the peak
/// value to date is added if it clearly exceeds the current value.
/// \param blocksFirst quantity listed first for a block; null: none.
/// \param boltsFirst quantity listed first for a bolt; null: none.
ProbeReading probed(const SectionPicture& picture, const Frame& frame, const Pick& pick,
                    const FrameQuantity<BlockState>* blocksFirst, const FrameQuantity<BoltNodeFrame>* boltsFirst);

}  // namespace keyblock
