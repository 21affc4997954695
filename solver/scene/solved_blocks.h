// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of solved blocks, shared by the engine, the results and the tables: the
// scene's blocks, each either whole or divided into its cells, followed by the plates
// modelled as blocks. The rows of a frame and all block indices in results refer to it.
#pragma once

#include "geometry/cells/sub_blocks.h"
#include "solver/scene/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace keyblock {

struct SolvedBlock {
    std::string name;  // name of the block; for a cell BLOCK:1, BLOCK:2, …; for a plate BOLT:plate
    int block = -1;  // index of the scene's block; for a plate, of the block it lies against
    bool cell = false;  // true for a cell of this block
    int plateOf = -1;  // index of the bolt for a plate; −1: not a plate
    std::vector<Point> points;  // corners relative to `SolvedBlocks::origin` [m]
    std::vector<char> inner;  // per edge: 1 if glued over its whole length; empty: no edge is
};

struct SolvedBlocks {
    Point origin{0.0, 0.0};  // subtracted from every coordinate of the scene
    std::vector<SolvedBlock> blocks;
    std::vector<int> firstOf;  // first row of each block of the scene, then of the plates
    std::vector<SharedEdge> glued;  // edges between cells of the same block; `a` and `b` are rows
};

/// The solved blocks of a scene after `cutScene`.
/// \pre the scene has been checked and has no errors, or it has neither cells nor plates modelled as blocks.
SolvedBlocks solvedBlocks(const Scene& scene);

/// Names of all solved blocks, in the order of `SolvedBlocks::blocks`. \pre as for `solvedBlocks`.
std::vector<std::string> blockNames(const Scene& scene);

/// Numbers of corners of all solved blocks, in the same order. \pre as for `solvedBlocks`.
std::vector<std::size_t> cornerCounts(const Scene& scene);

}  // namespace keyblock
