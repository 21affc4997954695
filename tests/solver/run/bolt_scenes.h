// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tests of bolts in whole runs share: blocks with a gap between, so
// that a bolt alone joins them.
#pragma once

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

namespace keyblock {

/// A fixed block that ends at x = 1 m, and one that begins `gap` [m] further; rigid, without contact.
inline Scene gapBlocks(double gap) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    scene.analysis.tolerance = 1e-8;  // stiff springs round off more
    for (Point& p : scene.blocks[1].points) p.x() += gap;
    scene.monitors[0].between = {Point(0.5, 0.5), Point(1.5 + gap, 0.5)};
    return scene;
}

}  // namespace keyblock
