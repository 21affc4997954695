// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From the engine's state to what people read: frames and the values of a
// history row, with displacements counted from a reference.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// True for contacts that a frame shows.
bool isShown(const Contact& contact);

/// Where displacements count from: the start, or the last `zero_displacements`.
struct Reference {
    std::vector<Point> centroids;
    std::vector<double> angles;
    std::vector<Point> monitorPoints;  // two a monitor; unused ones zero
};

class Observation {
public:
    /// \param reference filled here and kept by the caller, who may put back what it was.
    Observation(const Scene& scene, const Model& model, const State& start, Reference& reference);

    /// Counts displacements from here on.
    void zero(const State& state);

    Frame frame(const State& state, int stage, double time) const;
    HistoryRow history(const State& state, int stage, double time) const;

    /// Takes the blocks in `state` into account. \param extremes a row per block.
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
    std::vector<std::array<Fixed, 2>> fixed_;  // a row per monitor
    Reference& reference_;
};

}  // namespace keyblock
