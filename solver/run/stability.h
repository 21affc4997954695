// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Blocks that are unstable at the end of a stage: those that collapsed, and those that
// were displaced too far or still move. Displacements are measured relative to what
// the block touched or was bolted to at the start of the stage, so that settlement,
// heave and strain of the whole section do not count (theory, "Equilibrium").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/scene/scene.h"

#include <utility>
#include <vector>

namespace keyblock {

/// Block positions at one time of a dynamic stage.
struct BlockPositions {
    double time = 0.0;  // [s]
    std::vector<Point> centroids;  // [m]; empty if that time has not been reached yet
};

/// Reference positions for judging the stability of a stage at its end; plain values, part of the checkpoint.
struct StageStart {
    std::vector<BlockMotion> blocks;
    std::vector<std::pair<int, int>> joined;  // indices of blocks that touched or were bolted to each other
    BlockPositions nine, eight;  // positions at 90 % and 80 % of the duration of a dynamic stage
};

StageStart startOfStage(const Model& model, const State& state);

/// Records the positions at 80 % and 90 % of the duration of a dynamic stage once these times are reached.
void mark(StageStart& start, const State& state, double time, double duration);

/// Finds the unstable blocks at the end of a stage. Except for the list that `collapsed` returns, the lists
/// are in order of block index.
class Stability {
public:
    /// \param loads the loads of the stage. Blocks moved by prescribed motions or dilations of the stage, and all
    ///        blocks joined to them directly or through other blocks that are not fixed, are not judged.
    Stability(const Model& model, const StageStart& start, const State& state, const Stage& stage, const Loads& loads);

    /// Unstable blocks of a collapse. `blocks` come first, in the given order. After them come `followers` and every
    /// other block that the collapse has moved by more than a twentieth of the block's size, even if the block is at
    /// rest again; their movement is `Movement::Follows`.
    std::vector<UnstableBlock> collapsed(const std::vector<int>& blocks, const std::vector<int>& followers) const;

    /// Blocks that came to rest after a displacement of more than `share` times their size (centroid to farthest
    /// corner), and the blocks joined to them that moved at least 0.9 times as far.
    std::vector<UnstableBlock> displaced(double share) const;

    /// Blocks that are unstable in a dynamic stage: they fell, moved by more than their own size, or are still moving
    /// without slowing down at the end of the stage.
    /// \param continued another dynamic stage follows: it shows whether blocks that are still moving come to rest.
    std::vector<UnstableBlock> moving(bool continued) const;

    /// The block that moved most relative to its size, among the blocks that the stability verdict considers. If there
    /// is none, `block` is −1.
    UnstableBlock farthest() const;

    /// Blocks removed in this stage because they are too small to affect the verdict.
    std::vector<int> loose() const;

private:
    bool decides(int first) const;
    void exemptDriven(const Loads& loads);
    double reach(int first) const;
    double moved(int first) const;
    double movedItself(int first) const;
    double movedFrom(int row, int other) const;
    Point velocity(int row) const;
    std::vector<double> speeds() const;
    bool keepsItsSpeed(int first) const;
    UnstableBlock describe(int first) const;
    std::vector<UnstableBlock> describeAll(const std::vector<int>& blocks) const;
    std::vector<int> displacedBlocks(double share) const;

    const Model& model_;
    const StageStart& start_;
    const State& state_;
    const Stage& stage_;
    double smallest_;  // smallest area of a block that counts for stability [m²]
    std::vector<char> exempt_;  // one per row
    std::vector<std::vector<std::pair<int, int>>> neighbours_;  // by first row: (own row, neighbour)
};

}  // namespace keyblock
