// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which blocks a bolt runs through at the start, and where. The edges between
// the cells of one block are no joints: the bolt passes from cell to cell as
// through one rock, also where it runs along such an edge.
#pragma once

#include "solver/engine/model/model.h"

#include <vector>

namespace keyblock {

/// Boreholes of a bolt in blocks and cells, sorted along it; none in plates.
std::vector<Slot> slotsAlong(const Model& model, const Point& farEnd, const Point& head);

/// Where slots end inside the bolt: joints and faces of gaps, from the far end [m].
std::vector<double> jointPlaces(const Model& model, const std::vector<Slot>& slots, double length);

/// The block at `s` [m] along the bolt; −1 in a gap, on a joint or outside. Between cells, the first.
int startBlockOf(const Model& model, const std::vector<Slot>& slots, double s);

}  // namespace keyblock
