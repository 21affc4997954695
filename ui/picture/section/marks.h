// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks on a bolt: bonded and intermediate nodes, slipping and failed bond, yielded or
// ruptured steel, and the face plate. For bonds the current state of the node counts,
// not past events: a bond that has re-stuck is no longer marked as slipping.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <span>
#include <vector>

namespace keyblock {

/// Bonded, slipping and failed (`Gone`) bond; intermediate nodes in a block (`Artificial`) and outside any block
/// (`InGap`); yielded and ruptured steel; face plate in place and lost.
enum class MarkKind { Bonded, Artificial, InGap, Slipping, Gone, Yielded, Ruptured, Plate, PlateLost };

struct Mark {
    MarkKind kind = MarkKind::Bonded;
    double s = 0.0;  // distance from the far end [m]
    Point place{0.0, 0.0};  // position as drawn [m]
    Point along{1.0, 0.0};  // unit vector along the bolt at this point, towards the head
};

/// All marks of a bolt, in no particular order.
/// \param index index of the bolt in the scene. \param nodes positions of its nodes as drawn [m].
/// \param events the events of the run up to the frame.
std::vector<Mark> marksOf(const Bolt& bolt, int index, const BoltFrame& frame, const std::vector<Point>& nodes,
                          std::span<const Event> events);

/// The marks, thinned out where they are close together, in ascending order of importance. The mark of a bonded or
/// intermediate node is dropped if another mark that is drawn is closer than `least` [m]. Any other mark is dropped
/// only if a mark of the same kind is closer than 0.6 times `least`.
std::vector<Mark> thinned(std::vector<Mark> marks, double least);

}  // namespace keyblock
