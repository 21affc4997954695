// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The marks on a bolt: anchored points by kind and state, yielded or ruptured steel,
// the face plate. If events and node state differ, the state counts: a bond that has
// re-stuck is no longer slipping.
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

/// All marks of a bolt, unsorted. `nodes` [m] as drawn, `events` events of the run up to the frame.
std::vector<Mark> marksOf(const Bolt& bolt, int index, const BoltFrame& frame, const std::vector<Point>& nodes,
                          std::span<const Event> events);

/// The marks, at least `least` [m] apart: bonded and intermediate points are dropped first. Marks of failures keep 0.6
/// of that from their own kind, and are dropped for no other.
std::vector<Mark> thinned(std::vector<Mark> marks, double least);

}  // namespace keyblock
