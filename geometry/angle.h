// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles as the user types them. A quarter turn is exact, so a joint of dip 90 runs
// along a vertical border and not 6e-17 away from it.
#pragma once

#include "geometry/point.h"

namespace keyblock {

inline constexpr double radiansPerDegree = 0.017453292519943295;

/// The unit vector `degrees` counter-clockwise from +x; exact at multiples of 90.
Point directionOf(double degrees);

}  // namespace keyblock
