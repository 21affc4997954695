// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Check whether anything in a scene can shear a bolt at a joint. In a pull test nothing
// can, and elements short enough for dowel action would increase the cost tenfold.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// True if anything in the scene can shear the bolt at a joint. False only for a pull test along the bolt. In such a
/// scene there is no other bolt and no gravity, acceleration, in-situ or initial stress, pressure, dilation or point
/// support. All block edges are parallel or perpendicular to the bolt, and all loads, motions and initial velocities
/// act along the bolt's line without rotating any block.
bool actsAcross(const Scene& scene, const BoltModel& bolt, const Model& model);

}  // namespace keyblock
