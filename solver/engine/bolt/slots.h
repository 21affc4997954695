// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks crossed by a bolt at the start, and the intervals of the bolt in them. Edges
// between the cells of one block are not joints: the bolt passes from cell to cell as
// through continuous rock, even if it runs along such an edge.
#pragma once

#include "solver/engine/model/model.h"

#include <vector>

namespace keyblock {

/// Borehole slots of a bolt in blocks and cells, sorted from the far end; plates are ignored.
std::vector<Slot> slotsAlong(const Model& model, const Point& farEnd, const Point& head);

/// Positions within the bolt at which slots end, i.e. at joints and at the faces of gaps; distances from the far end
/// [m], sorted.
std::vector<double> jointPlaces(const Model& model, const std::vector<Slot>& slots, double length);

/// Index of the block at distance `s` [m] from the far end of the bolt; −1 in a gap, on a joint or outside the rock. On
/// an edge between cells of one block, the first of these cells.
int startBlockOf(const Model& model, const std::vector<Slot>& slots, double s);

}  // namespace keyblock
