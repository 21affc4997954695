// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Positions for drawing: actual ones, or with the displacements since the start of the
// run multiplied by a scale factor.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/solved_blocks.h"

#include <vector>

namespace keyblock {

/// Initial corners of all solved blocks [m]. Blocks and corners have the same order as in a frame.
std::vector<std::vector<Point>> cornersBefore(const SolvedBlocks& solved);

/// Corners with scaled displacements: before + factor · (now − before). \pre `before` and `now` have the same number of
/// corners.
std::vector<Point> deformed(const std::vector<Point>& before, const std::vector<Point>& now, double factor);

/// Position of a point of a block as drawn: the point is shifted by the same vector as the nearest corner.
/// \param now actual corners of the block. \param drawn its corners as drawn.
Point carriedAlong(const Point& place, const std::vector<Point>& now, const std::vector<Point>& drawn);

/// Positions of a bolt's nodes as drawn [m]. The displacement of each node from its initial position on the straight
/// bolt of the scene is multiplied by `factor`.
std::vector<Point> deformedNodes(const Bolt& bolt, const BoltFrame& frame, double factor);

}  // namespace keyblock
