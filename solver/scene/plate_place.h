// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the plate of a bolt lies when it is a block: flat against the face at
// the bolt's head, regardless of the bolt's own direction.
#pragma once

#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

enum class PlateFault {
    None,
    NoFace,  // no face at the head
    Corner,  // two faces at the head
    InRock,  // against every face there the plate would overlap rock
    Behind  // the bolt does not come out of that face
};

struct PlatePlace {
    PlateFault fault = PlateFault::None;
    double away = 0.0;  // from the head to the nearest face [m]
    int block = -1;  // whose face it is, the first in order
    Point foot{0.0, 0.0};  // the head on the face, the middle of the plate's near side [m]
    Point outward{0.0, 0.0};  // unit vector out of the rock
    double overhang = 0.0;  // width that no face backs [m]
    std::vector<Point> outline;  // counter-clockwise, the near side first [m]
};

/// \pre blocks are sound and the bolt's type is known.
PlatePlace placePlate(const Scene& scene, const Bolt& bolt);

}  // namespace keyblock
