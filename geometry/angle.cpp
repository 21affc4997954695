// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole quarter turns are subtracted exactly. Sine and cosine are evaluated only for the remainder, which is at most an
// eighth of a turn.
#include "geometry/angle.h"

#include <cmath>

namespace keyblock {

Point directionOf(double degrees) {
    const double rest = std::remainder(degrees, 90.0);
    const double quarters = std::remainder(degrees - rest, 360.0) / 90.0;  // -2, -1, 0, 1 or 2
    Point direction{std::cos(rest * radiansPerDegree), std::sin(rest * radiansPerDegree)};
    for (long turns = (std::lround(quarters) + 4) % 4; turns > 0; --turns) direction = turnLeft(direction);
    return direction;
}

}  // namespace keyblock
