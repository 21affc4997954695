// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kinds of block edges: joints between two blocks, walls of an opening, the border of
// the model, seams between the cells of one block. Only present blocks count, so the
// wall of a tunnel appears with its excavation. An edge may be part joint and part
// wall.
#pragma once

#include "solver/scene/solved_blocks.h"

#include <vector>

namespace keyblock {

enum class FaceKind { Joint, Wall, Border, Seam };

/// A piece of an edge of a block; positions are fractions of the edge.
struct FacePiece {
    FaceKind kind = FaceKind::Joint;
    int block = -1;  // row of the solved blocks
    int edge = -1;  // from corner `edge` to the next
    double from = 0.0, to = 1.0;
};

/// All pieces, by block, edge and position. `corners` [m] as from `cornersBefore`, `present` one row per block.
std::vector<FacePiece> facePieces(const Scene& scene, const SolvedBlocks& solved,
                                  const std::vector<std::vector<Point>>& corners, const std::vector<char>& present);

}  // namespace keyblock
