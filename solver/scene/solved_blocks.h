// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The list of blocks that are solved, made in one place for engine, results and
// tables: the scene's blocks, each whole or as its cells, then the plates that
// are blocks. Rows of a frame, and every index of a block in a result, follow it.
#pragma once

#include "geometry/sub_blocks.h"
#include "solver/scene/scene.h"

#include <string>
#include <vector>

namespace keyblock {

struct SolvedBlock {
    std::string name;  // the block's; of a cell BLOCK:1, BLOCK:2, …; of a plate BOLT:plate
    int block = -1;  // the scene's block that it is, or is cut from; of a plate, the one that it lies against
    bool cell = false;  // cut from that block
    int plateOf = -1;  // bolt whose plate it is
    std::vector<Point> points;  // from `SolvedBlocks::origin` [m]
    std::vector<char> inner;  // a row per edge: glued from end to end; empty: none
};

struct SolvedBlocks {
    Point origin{0.0, 0.0};  // subtracted from every coordinate of the scene
    std::vector<SolvedBlock> blocks;
    std::vector<int> firstOf;  // row where each block of the scene begins, then where the plates do
    std::vector<SharedEdge> glued;  // between cells of one block, by rows
};

/// \pre the scene was checked without errors, or has no cells and no plates as blocks; what `cutScene` makes of it.
SolvedBlocks solvedBlocks(const Scene& scene);

/// Names of all blocks that are solved, in the order of the rows. \pre as above.
std::vector<std::string> blockNames(const Scene& scene);

}  // namespace keyblock
