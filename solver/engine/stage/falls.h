// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether blocks fall while rest is sought. A pseudo-step begins at rest, so what
// moves by d in it is accelerated by 2d/Δt²: something that only gives way a little
// is slower in each step, something that falls or slides is not (theory,
// "Equilibrium").
#pragma once

#include "solver/engine/model/state.h"

#include <deque>
#include <vector>

namespace keyblock {

class Falls {
public:
    /// \param share of its weight that may be unbalanced on a block at rest. \param smallest [m²]: blocks of less area do
    /// not decide.
    Falls(const Model& model, const State& state, double share, double smallest);

    /// Takes note of a pseudo-step.
    /// \param moves of the blocks in it [m]. \param own weights of the blocks, or what stands for them [N].
    void note(const std::vector<double>& moves, double dt, const std::vector<double>& own);

    /// True where a block has fallen without being slowed down, and so far that no strain will hold it.
    bool falls(const std::vector<BlockMotion>& blocks, int block) const;

    /// True where the last pseudo-step and the one before it, of another length, accelerated a block alike.
    bool sameWhateverTheStep(int block) const;

    /// How far the centroid of a block has moved since the start, over the block's size; of a cell over that of all cells of its
    /// block.
    double moved(const std::vector<BlockMotion>& blocks, int block) const;

    /// True for a block that is large enough to decide whether there is an equilibrium.
    bool decides(int block) const { return !small_[static_cast<std::size_t>(block)]; }

    /// True where a block has moved by more than its size.
    bool hasLeft(const std::vector<BlockMotion>& blocks, int block) const { return moved(blocks, block) > 1.0; }

    /// True where others have set a block moving, and it still goes.
    bool follows(const std::vector<BlockMotion>& blocks, int block) const;

    /// Rows of blocks that do not decide and fall or have left their place.
    std::vector<int> loosePieces(const std::vector<BlockMotion>& blocks) const;

private:
    bool isCaught(int block) const;

    const Model& model_;
    std::vector<Point> places_;  // of the centroids at the start [m]
    std::vector<double> sizes_;  // √area of the blocks, of a cell that of the whole block [m]
    std::vector<char> small_;  // too small to decide
    double share_;
    std::vector<char> bolted_;  // bolts hold on to the block
    std::deque<std::vector<double>> accelerations_;  // in the last pseudo-steps, over what `own` would give the blocks
    std::deque<std::vector<double>> moves_;  // in the same [m]
};

}  // namespace keyblock
