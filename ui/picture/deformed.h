// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where things are drawn: in their place, or with their displacements since the
// start of the run enlarged.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/solved_blocks.h"

#include <vector>

namespace keyblock {

/// The corners of all solved blocks before anything moved [m], in the order of a frame's rows and corners.
std::vector<std::vector<Point>> cornersBefore(const SolvedBlocks& solved);

/// before + factor · (now − before), corner by corner. \pre as many corners as before.
std::vector<Point> deformed(const std::vector<Point>& before, const std::vector<Point>& now, double factor);

/// A place in a block, carried along with the nearest of its corners.
Point carriedAlong(const Point& place, const std::vector<Point>& now, const std::vector<Point>& drawn);

/// The nodes of a bolt [m]: each from where it lay along the straight bolt of the scene.
std::vector<Point> deformedNodes(const Bolt& bolt, const BoltFrame& frame, double factor);

}  // namespace keyblock
