// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What stands on a bolt besides its shank: anchored points by kind and state,
// steel that yielded or broke, the plate. The state of a node decides, not the
// list of events, where both tell: a bond that stuck again is no longer slipping.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <span>
#include <vector>

namespace keyblock {

enum class MarkKind { Bonded, Artificial, InGap, Slipping, Gone, Yielded, Ruptured, Plate, PlateLost };

struct Mark {
    MarkKind kind = MarkKind::Bonded;
    double s = 0.0;  // [m] from the far end
    Point place{0.0, 0.0};  // [m], as drawn
    Point along{1.0, 0.0};  // unit vector of the bolt there, towards the head
};

/// All marks of a bolt, unsorted. `nodes` [m] as drawn, `events` those of the run until the frame.
std::vector<Mark> marksOf(const Bolt& bolt, int index, const BoltFrame& frame, const std::vector<Point>& nodes,
                          std::span<const Event> events);

/// The marks that keep `least` [m] between them: bonded and artificial points give way first. What let go keeps 0.6 of
/// it from its like, and gives way to nothing else.
std::vector<Mark> thinned(std::vector<Mark> marks, double least);

}  // namespace keyblock
