// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/activity.h"

#include "solver/scene/lookup.h"

namespace keyblock {

// Slate, as for all colours of blocks: those of Ember belong to bolts. The three differ in lightness.
Colour colourOf(BlockActivity activity, bool dark) {
    switch (activity) {
        case BlockActivity::Active: return dark ? rgb(0x6FA3AB) : rgb(0x628C99);
        case BlockActivity::Asleep: return dark ? rgb(0x263647) : rgb(0xD2DED4);
        case BlockActivity::Fixed: break;
    }
    return dark ? rgb(0x4A4F57) : rgb(0xB9B6AF);
}

std::vector<char> fixedBlocks(const Scene& scene, const SolvedBlocks& solved) {
    std::vector<char> fixed(solved.blocks.size(), 0);
    for (const Support& support : scene.supports) {
        if (!support.blockAt || support.fix != Fix::All) continue;
        const int block = blockAt(scene, *support.blockAt);
        for (std::size_t row = 0; block >= 0 && row < fixed.size(); ++row)
            if (solved.blocks[row].block == block && solved.blocks[row].plateOf < 0) fixed[row] = 1;
    }
    return fixed;
}

BlockActivity activityOf(const BlockState& block, bool fixed, bool inMotion) {
    if (fixed) return BlockActivity::Fixed;
    return inMotion && block.velocity.isZero(0.0) ? BlockActivity::Asleep : BlockActivity::Active;
}

}  // namespace keyblock
