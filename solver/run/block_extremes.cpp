// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/block_extremes.h"

#include "solver/results/frame_quantities.h"

namespace keyblock {

void addExtreme(const BlockState& block, int stage, double time, BlockExtremes& extremes) {
    const auto raise = [&](BlockPeak& peak, double value) {
        if (peak.stage < 0 || value > peak.value) peak = {value, stage, time};
    };
    const auto lower = [&](BlockPeak& peak, double value) {
        if (peak.stage < 0 || value < peak.value) peak = {value, stage, time};
    };
    const auto [sigma1, sigma3] = principalValues(block.stress);
    raise(extremes.displacement, block.displacement.norm());
    raise(extremes.velocity, block.velocity.norm());
    raise(extremes.sigma1, sigma1);
    lower(extremes.sigma3, sigma3);
}

void forgetDisplacements(std::vector<BlockExtremes>& extremes) {
    for (BlockExtremes& block : extremes) block.displacement = {};
}

}  // namespace keyblock
