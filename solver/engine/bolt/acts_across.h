// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether anything in a scene can shear a bolt at a joint. In a pull test nothing
// does, and elements short enough for a dowel would cost ten times the rest.
#pragma once

#include "solver/engine/model/model.h"

namespace keyblock {

/// False where every load, motion, velocity and acceleration of the scene acts along `axis`, there is no stress in the
/// rock, and each joint that the bolt crosses is square to it.
bool actsAcross(const Scene& scene, const Model& model, const Point& axis, const std::vector<Slot>& slots);

}  // namespace keyblock
