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
    /// \param share of its weight that may be unbalanced on a block at rest.
    Falls(const Model& model, const std::vector<BlockMotion>& blocks, double share);

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

private:
    const Model& model_;
    std::vector<Point> places_;  // of the centroids at the start [m]
    std::vector<double> sizes_;  // √area of the blocks, of a cell that of the whole block [m]
    double share_;
    std::deque<std::vector<double>> accelerations_;  // in the last pseudo-steps, over what `own` would give the blocks
};

}  // namespace keyblock
