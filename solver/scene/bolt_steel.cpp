// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/bolt_steel.h"

#include <algorithm>
#include <numbers>

namespace keyblock {

double fullBarArea(double diameter) { return std::numbers::pi * diameter * diameter / 4.0; }

BoltSteel boltSteel(const BoltType& type) {
    BoltSteel steel;
    steel.area = type.area.value_or(fullBarArea(type.diameter));
    double largest = 0.0;
    for (const auto& [strain, stress] : type.steel) {
        if (strain > 0.0 && !steel.yield) steel.yield = steel.area * stress;
        largest = std::max(largest, stress);
    }
    const double strength = type.steel.empty() ? 0.0 : type.tensileStrength.value_or(largest);
    if (strength > 0.0) steel.tensile = strength * steel.area;
    return steel;
}

}  // namespace keyblock
