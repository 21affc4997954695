// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a step models of the blocks of a frame: those that are active, those that are
// asleep in a dynamic stage, and those that are fixed, which have no unknowns.
#pragma once

#include "solver/results/run_source.h"
#include "solver/scene/solved_blocks.h"
#include "ui/picture/colour.h"

#include <optional>
#include <vector>

namespace keyblock {

enum class BlockActivity { Active, Asleep, Fixed };

/// Numbers of blocks, for the legend.
struct ActivityCounts {
    int active = 0, asleep = 0, fixed = 0;
    int removed = 0;  // excavated, or not active yet; not drawn
};

Colour colourOf(BlockActivity activity, bool dark);

/// Whether each solved block is fixed as a whole by a support.
std::vector<char> fixedBlocks(const Scene& scene, const SolvedBlocks& solved);

/// The activity of a block that is there. A sleeping block is left out of the steps with its velocity zero, and no block
/// that moves with a step of a dynamic stage has exactly this velocity.
/// \param inMotion whether the frame follows a step of a dynamic stage.
BlockActivity activityOf(const BlockState& block, bool fixed, bool inMotion);

}  // namespace keyblock
