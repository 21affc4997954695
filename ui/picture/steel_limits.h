// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Loads at which the steel of a bolt yields and ruptures, for capacity lines.
#pragma once

#include "solver/scene/scene.h"

#include <optional>

namespace keyblock {

struct SteelLimits {
    std::optional<double> yield;  // axial load at the end of the first piece of the steel's curve [N]
    std::optional<double> ultimate;  // at its largest stress [N]
};

/// None for steel that is linear and unbreakable.
SteelLimits steelLimits(const BoltType& type);

/// The bolt's type; null if the scene does not have it.
const BoltType* typeOf(const Scene& scene, const Bolt& bolt);

}  // namespace keyblock
