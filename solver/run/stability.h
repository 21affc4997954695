// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which blocks are unstable at the end of a stage: those that a collapse took, and
// those that lie or move too far from where the stage found them. How far is seen
// from what a block touched or was bolted to then, so that settlement, heave and
// strain of a whole section do not count (theory, "Equilibrium").
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/scene/scene.h"

#include <utility>
#include <vector>

namespace keyblock {

/// Where a dynamic stage had brought the blocks.
struct Mark {
    double time = 0.0;  // [s]
    std::vector<Point> centroids;  // [m]; empty: not reached yet
};

/// What a stage is judged by at its end; plain values, part of the checkpoint.
struct StageStart {
    std::vector<BlockMotion> blocks;
    std::vector<std::pair<int, int>> joined;  // rows that touched or were bolted to each other
    Mark nine, eight;  // at nine and at eight tenths of a dynamic stage
};

StageStart startOfStage(const Model& model, const State& state);

/// Takes the marks that a dynamic stage has come to.
void mark(StageStart& start, const State& state, double time, double duration);

/// The unstable blocks, in the order of their rows; of a collapse and of what follows in the order given.
class Stability {
public:
    /// \param loads of the stage: what they drive is exempt.
    Stability(const Model& model, const StageStart& start, const State& state, const Stage& stage, const Loads& loads);

    /// \param followers are reported as such, and so is every other block that the collapse has moved by more than a
    /// twentieth of its size, whether it still moves or has come to rest.
    std::vector<UnstableBlock> collapsed(const std::vector<int>& blocks, const std::vector<int>& followers) const;

    /// Blocks that have come to rest more than `share` of their size (centroid to farthest corner) away, and those joined
    /// to them that went as far.
    std::vector<UnstableBlock> displaced(double share) const;

    /// Blocks that fell, lie farther than their own size away, or still move at the end of a dynamic stage as fast as
    /// before.
    std::vector<UnstableBlock> moving() const;

    /// Of the blocks that decide, the one that moved most over its size; row −1 where none does.
    UnstableBlock farthest() const;

    /// Blocks too small to decide that this stage has removed.
    std::vector<int> loose() const;

private:
    bool decides(int first) const;
    void exemptDriven(const Loads& loads);
    double reach(int first) const;
    double moved(int first) const;
    double movedItself(int first) const;
    double movedFrom(int row, int other) const;
    double speed(int first) const;
    bool keepsItsSpeed(int first) const;
    UnstableBlock describe(int first) const;
    std::vector<UnstableBlock> describeAll(const std::vector<int>& blocks) const;
    std::vector<int> displacedBlocks(double share) const;

    const Model& model_;
    const StageStart& start_;
    const State& state_;
    const Stage& stage_;
    double smallest_;  // area of blocks that decide [m²]
    std::vector<char> exempt_;  // a row per block
    std::vector<std::vector<std::pair<int, int>>> neighbours_;  // of the first row of a block: its row, and the other's
};

}  // namespace keyblock
