// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/steel_limits.h"

#include <algorithm>
#include <numbers>

namespace keyblock {

SteelLimits steelLimits(const BoltType& type) {
    SteelLimits limits;
    const double area = type.area.value_or(std::numbers::pi / 4.0 * type.diameter * type.diameter);
    double largest = 0.0;
    for (const auto& [strain, stress] : type.steel) {
        if (strain > 0.0 && !limits.yield) limits.yield = area * stress;
        largest = std::max(largest, stress);
    }
    if (type.tensileStrength) largest = *type.tensileStrength;
    if (largest > 0.0) limits.ultimate = area * largest;
    return limits;
}

const BoltType* typeOf(const Scene& scene, const Bolt& bolt) {
    for (const BoltType& type : scene.boltTypes)
        if (type.name == bolt.type) return &type;
    return nullptr;
}

}  // namespace keyblock
