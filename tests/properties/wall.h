// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A brick wall in running bond on a fixed base: the scene on which properties of
// whole runs are tried. Bricks are 1 m × 0.5 m, half bricks close
// the ends, and all coordinates are exact in binary.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

struct WallSetting {
    int columns = 3, rows = 3;
    double frictionAngle = 30.0;  // [°]
    Point gravity{0.0, -9.81};  // [m/s²]
    double duration = 0.01;  // [s]
    double timeStep = 1e-3;  // [s]
};

/// One dynamic stage of `duration`; pass tolerance 1e-10.
Scene brickWall(const WallSetting& setting);

/// A wall that settles in a static stage and then stays for `duration` in a dynamic one; the program's own tolerance.
Scene settledWall(int columns, int rows, double duration = 0.1);

/// The same, with a friction angle of 20° and an acceleration of g·sin 25° along the wall in the dynamic stage.
Scene tiltedWall(int columns, int rows, double duration = 0.1);

/// The scene with every coordinate of a block or support moved by `by` [m].
Scene moved(Scene scene, const Point& by);

/// The scene as a mirror at x = 0 shows it.
Scene mirrored(Scene scene);

}  // namespace keyblock
