// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cross-sectional area and strength of the steel of a bolt type, computed in one place
// for the engine, the figures, the bolt library and the command line.
#pragma once

#include "solver/scene/scene.h"

#include <optional>

namespace keyblock {

struct BoltSteel {
    double area = 0.0;  // [m²]
    std::optional<double> yield;  // axial force [N] at the end of the first segment of `steel`; none: linear
    std::optional<double> tensile;  // axial force [N] at the tensile strength; none: without rupture
};

/// Area and strength of the steel of a type. The steel of a type without `steel` is linear and does not rupture, even
/// if the type gives a tensile strength. The type need not have been checked.
BoltSteel boltSteel(const BoltType& type);

/// Cross-sectional area [m²] of a solid bar of this diameter [m].
double fullBarArea(double diameter);

}  // namespace keyblock
