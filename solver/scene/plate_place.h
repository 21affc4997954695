// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Position of a bearing plate that is modelled as a block: flat against the face at
// the bolt's head, whatever the direction of the bolt.
#pragma once

#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

enum class PlateFault {
    None,
    NoFace,  // no face at the head
    Corner,  // two faces of different direction at the head
    InRock,  // the plate would overlap rock on every face at the head
    Behind  // the bolt does not leave the rock through the face
};

struct PlatePlace {
    PlateFault fault = PlateFault::None;
    double away = 0.0;  // distance from the head to the nearest face [m]
    int block = -1;  // index of the first block with this face
    Point foot{0.0, 0.0};  // head projected onto the face, middle of the plate's side against the rock [m]
    Point outward{0.0, 0.0};  // unit vector out of the rock
    double overhang = 0.0;  // width of the plate without rock behind it [m]
    std::vector<Point> outline;  // counter-clockwise, starting with the side against the rock [m]
};

/// \pre the outlines of all blocks have been checked and have no errors, and the bolt's type exists.
PlatePlace placePlate(const Scene& scene, const Bolt& bolt);

}  // namespace keyblock
