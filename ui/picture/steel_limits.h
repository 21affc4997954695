// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loads at which the steel of a bolt yields and breaks, for capacity lines.
#pragma once

#include "solver/scene/scene.h"

#include <optional>

namespace keyblock {

struct SteelLimits {
    std::optional<double> yield;  // axial load at the end of the first piece of the steel's curve [N]
    std::optional<double> ultimate;  // at its largest stress [N]
};

/// Nothing of steel that is linear and unbreakable.
SteelLimits steelLimits(const BoltType& type);

/// The bolt's type; null when the scene does not hold it.
const BoltType* typeOf(const Scene& scene, const Bolt& bolt);

}  // namespace keyblock
