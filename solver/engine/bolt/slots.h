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

/// Positions at which slots end within the bolt, i.e. at joints and at the faces of gaps, as distances from the far end
/// [m].
std::vector<double> jointPlaces(const Model& model, const std::vector<Slot>& slots, double length);

/// Block at distance `s` [m] along the bolt; −1 in a gap, on a joint or outside the rock. On an edge between cells of
/// one block, the first of these cells.
int startBlockOf(const Model& model, const std::vector<Slot>& slots, double s);

}  // namespace keyblock
