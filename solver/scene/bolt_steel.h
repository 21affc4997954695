// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Area and strength of the steel of a bolt type. The model, the figures, the library
// and the command line take them from here, so that they agree.
#pragma once

#include "solver/scene/scene.h"

#include <optional>

namespace keyblock {

struct BoltSteel {
    double area = 0.0;  // [m²]
    std::optional<double> yield;  // axial force at the end of the first piece of `steel` [N]; none: linear
    std::optional<double> tensile;  // axial force at the tensile strength [N]; none: unbreakable
};

/// A type without `steel` is linear and unbreakable, even if it gives a tensile strength. The type need not be checked.
BoltSteel boltSteel(const BoltType& type);

/// Area of a full bar of this diameter [m → m²].
double fullBarArea(double diameter);

}  // namespace keyblock
