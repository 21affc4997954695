// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Classifies block edges: joints between two blocks, walls of an opening, the border of
// the model, and seams between the cells of one block. Only blocks present at the time
// count, so the wall of a tunnel appears when the tunnel is excavated. One edge may be
// partly joint and partly wall.
#pragma once

#include "solver/scene/solved_blocks.h"

#include <vector>

namespace keyblock {

enum class FaceKind { Joint, Wall, Border, Seam };

/// A part of a block edge; `from` and `to` are fractions of the edge length.
struct FacePiece {
    FaceKind kind = FaceKind::Joint;
    int block = -1;  // row of the solved blocks
    int edge = -1;  // the edge from corner `edge` to the next corner
    double from = 0.0, to = 1.0;
};

/// Pieces of all edges of the blocks that are present, sorted by block, then by edge, then by position along the edge.
/// \param corners initial corners of the solved blocks [m], from `cornersBefore`.
/// \param present one flag for each solved block: non-zero if the block is present.
std::vector<FacePiece> facePieces(const Scene& scene, const SolvedBlocks& solved,
                                  const std::vector<std::vector<Point>>& corners, const std::vector<char>& present);

}  // namespace keyblock
