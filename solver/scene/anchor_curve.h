// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonds that soften gradually. A scene gives their strength, residual strength and
// softening slip; the engine models them by the equivalent force–slip curve.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// The anchor with its softening slip replaced by a force–slip curve. An anchor that lacks a softening slip, a strength
/// or a stiffness is returned unchanged.
Anchor withCurve(const Anchor& anchor);

}  // namespace keyblock
