// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results that are not finite numbers: those of a stage that failed, or of a damaged
// run file. They are not drawn, and a sentence says so.
#pragma once

#include "solver/results/results.h"

#include <string>

namespace keyblock {

/// True if all corners of the block can be shown.
bool canBeDrawn(const BlockState& block);

/// True if the positions of all nodes of the bolt can be shown.
bool canBeDrawn(const BoltFrame& bolt);

/// States how many blocks and bolts of a frame have positions or values that are not finite numbers, or exceed 1e100;
/// empty if there are none.
std::string notFiniteText(const Frame& frame);

}  // namespace keyblock
