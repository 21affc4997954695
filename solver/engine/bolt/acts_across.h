// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether anything in a scene can shear a bolt at a joint. In a pull test nothing
// does, and elements short enough for a dowel would cost ten times the rest.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// False in a pull test along the bolt alone: the scene has no other bolt, no weight, acceleration, stress, pressure,
/// dilation or point support; every edge of its blocks is parallel or square to the bolt; and every load, motion and
/// velocity acts along the bolt's own line and turns no block.
bool actsAcross(const Scene& scene, const BoltModel& bolt, const Model& model);

}  // namespace keyblock
