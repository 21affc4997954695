// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which blocks are large enough to decide whether a stage is stable.
#pragma once

#include "solver/scene/automatic.h"

namespace keyblock {

/// Area under which a block does not decide [m²].
inline double smallestOf(const Stage& stage) { return stage.until.smallest.value_or(automaticSmallest); }

}  // namespace keyblock
