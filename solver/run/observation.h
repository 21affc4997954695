// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts the engine's state to results: frames and history rows, with
// displacements measured from a reference.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// True for contacts that are included in frames.
bool isShown(const Contact& contact);

/// Positions from which displacements are measured: at the start, or at the last `zero_displacements`.
struct Reference {
    std::vector<Point> centroids;
    std::vector<double> angles;
    std::vector<Point> monitorPoints;  // two per monitor; unused ones are zero
};

class Observation {
public:
    /// \param reference owned by the caller and filled in by the constructor; to resume a run, the caller overwrites
    /// it.
    Observation(const Scene& scene, const Model& model, const State& start, Reference& reference);

    /// Makes the positions in `state` the reference for displacements from now on.
    void zero(const State& state);

    Frame frame(const State& state, int stage, double time) const;
    HistoryRow history(const State& state, int stage, double time) const;

    /// Updates the extremes with the blocks in `state` that do not sleep. \param extremes one entry per block.
    void addExtremes(const State& state, int stage, double time, std::vector<BlockExtremes>& extremes) const;

private:
    struct Fixed {  // a point of a monitor, fixed in its block
        int block = -1;
        Point place{0.0, 0.0};
    };
    Point pointNow(const State& state, std::size_t monitor, std::size_t which) const;
    Point moved(const State& state, std::size_t monitor, std::size_t which) const;
    BlockState blockMoved(const State& state, int block) const;
    BlockState blockState(const State& state, int block) const;
    void addMonitor(const State& state, std::size_t monitor, std::vector<double>& values) const;

    const Scene& scene_;
    const Model& model_;
    std::vector<std::array<Fixed, 2>> fixed_;  // one entry per monitor
    Reference& reference_;
};

}  // namespace keyblock
