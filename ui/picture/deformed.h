// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions for drawing: actual ones, or with the displacements since the start of the
// run scaled.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/solved_blocks.h"

#include <vector>

namespace keyblock {

/// The corners of all solved blocks at the start [m], in the order of a frame's rows and corners.
std::vector<std::vector<Point>> cornersBefore(const SolvedBlocks& solved);

/// before + factor · (now − before), corner by corner. \pre as many corners as before.
std::vector<Point> deformed(const std::vector<Point>& before, const std::vector<Point>& now, double factor);

/// A point of a block, moved with the nearest of its corners.
Point carriedAlong(const Point& place, const std::vector<Point>& now, const std::vector<Point>& drawn);

/// The nodes of a bolt [m], each displaced from its initial position on the straight bolt of the scene.
std::vector<Point> deformedNodes(const Bolt& bolt, const BoltFrame& frame, double factor);

}  // namespace keyblock
