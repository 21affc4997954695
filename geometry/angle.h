// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles in degrees, as the user enters them. Multiples of 90° are exact, so that a
// joint with a dip of 90° is exactly parallel to a vertical boundary.
#pragma once

#include "geometry/point.h"

namespace keyblock {

inline constexpr double radiansPerDegree = 0.017453292519943295;

/// Unit vector at an angle counter-clockwise from +x; exact at multiples of 90°. \param degrees angle [°]
Point directionOf(double degrees);

}  // namespace keyblock
