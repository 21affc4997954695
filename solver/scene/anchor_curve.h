// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bond that softens over a slip is written by its strength, its residual and
// that slip, and acts as the force–slip curve which they make.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// The anchor with a curve in place of its softening slip; any other as it is, and one that lacks strength or stiffness.
Anchor withCurve(const Anchor& anchor);

}  // namespace keyblock
