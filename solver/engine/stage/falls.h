// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detection of falling blocks during the search for equilibrium. A pseudo-step starts
// from rest, so a block that moves by d in it has the acceleration 2d/Δt². The
// acceleration of a block that only settles decreases from step to step; that of a
// block that falls or slides does not (theory, "Equilibrium").
#pragma once

#include "solver/engine/model/state.h"

#include <deque>
#include <vector>

namespace keyblock {

struct FallSettings {
    double share = 0.0;  // unbalanced force allowed on a block at rest, as a fraction of its weight
    double smallest = 0.0;  // smaller blocks are disregarded in deciding whether there is an equilibrium [m²]
    const std::vector<Point>* from = nullptr;  // centroids before the fall; null: at the start of the search
};

class Falls {
public:
    Falls(const Model& model, const State& state, const FallSettings& settings);

    /// Records a pseudo-step of length `dt` [s].
    /// \param moves the displacement of each block [m].
    /// \param own the weight of each block, or the reference force used instead [N].
    void note(const std::vector<double>& moves, double dt, const std::vector<double>& own);

    /// True if a block is falling: it has moved too far to be stopped by elastic deformation and has not slowed down.
    bool falls(const std::vector<BlockMotion>& blocks, int block) const;

    /// True if a block had nearly the same acceleration in the last two pseudo-steps.
    /// \pre at least two pseudo-steps have been recorded, and the last two differ in length.
    bool sameWhateverTheStep(int block) const;

    /// Displacement of a block's centroid from its place before the fall, as a fraction of the size of the block or, for a
    /// cell, of the whole block.
    double moved(const std::vector<BlockMotion>& blocks, int block) const;

    /// True if a block is large enough to be considered in deciding whether there is an equilibrium.
    bool decides(int block) const { return !small_[block]; }

    /// True if a block has moved by more than its size.
    bool hasLeft(const std::vector<BlockMotion>& blocks, int block) const { return moved(blocks, block) > 1.0; }

    /// True if a block has moved noticeably and is still accelerating, as when other blocks have set it in motion.
    bool follows(const std::vector<BlockMotion>& blocks, int block) const;

    /// Indices of the blocks that are too small to be considered (see `decides`) and that are falling or have moved by
    /// more than their size. Of a block divided into cells, all cells are listed.
    std::vector<int> loosePieces(const std::vector<BlockMotion>& blocks) const;

private:
    bool isCaught(int block) const;

    const Model& model_;
    std::vector<Point> places_;  // centroids before the fall [m]
    std::vector<double> sizes_;  // √area per block; for a cell, √area of the whole block [m]
    std::vector<char> small_;  // per block: true if too small to decide
    double share_;
    std::size_t remembered_;  // number of pseudo-steps over which a fall must not slow down
    std::vector<char> bolted_;  // per block: true if a bolt crosses it
    std::deque<std::vector<double>> accelerations_;  // per pseudo-step and block, over that due to `own`
    std::deque<std::vector<double>> moves_;  // per pseudo-step and block [m]
};

}  // namespace keyblock
