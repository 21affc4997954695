// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Size of the blocks that decide whether a stage is stable.
#pragma once

#include "solver/scene/automatic.h"

namespace keyblock {

/// Area [m²] below which a block is ignored in judging whether the stage is stable.
inline double smallestOf(const Stage& stage) { return stage.until.smallest.value_or(automaticSmallest); }

}  // namespace keyblock
