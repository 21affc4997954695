// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/model/edge.h"

namespace keyblock {

Edge edgeOf(const std::vector<Point>& corners, int index) {
    const Point& a = corners[index];
    const Point chord = corners[(index + 1) % static_cast<int>(corners.size())] - a;
    const double length = chord.norm();
    const Point along = chord / length;
    return {a, along, -turnLeft(along), length};
}

}  // namespace keyblock
