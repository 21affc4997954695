// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonds that soften gradually. A scene gives their strength, residual strength and
// softening slip; the engine models them by the equivalent force–slip curve.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// The anchor with its softening slip replaced by a force–slip curve. Anchors without a softening slip, strength or
/// stiffness are returned unchanged.
Anchor withCurve(const Anchor& anchor);

}  // namespace keyblock
