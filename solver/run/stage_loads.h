// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loads of a run as its stages bring them: what a stage puts on stays with
// its last value in the stages after it, until one of them puts something else
// in its place.
#pragma once

#include "solver/engine/step_build.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// The load or motion of a stage that something acts by.
struct LoadSource {
    int stage = -1, row = -1;
    bool replaced = false;  // by a later stage: nothing acts any more
};

class StageLoads {
public:
    StageLoads(const Model& model, const Scene& scene) : model_(model), scene_(scene) {}

    /// Adds the loads and motions of a stage. A motion takes the place of an earlier one on its block, a load that of
    /// one of an earlier stage at the same place.
    void begin(int stage, State& state);

    const Loads& loads() const { return loads_; }

    /// What acted when the stage began.
    const LoadPoint& start() const { return start_; }

    /// What acts at `time` of the stage.
    LoadPoint at(double time) const;

    /// Times in (0, 1) at which a table of this stage turns.
    std::vector<double> turns() const;

    /// True where anything of this stage changes after its time 0.
    bool varies() const;

    /// Keeps what acts at the stage's end for the next.
    void end(const LoadPoint& reached) { start_ = reached; }

private:
    const Stage& stage() const { return scene_.stages[static_cast<std::size_t>(stage_)]; }
    const Load& loadOf(const LoadSource& source) const;
    void addLoad(int row, const State& state);
    void addSpread(int row, int block);
    void addForce(const PointForce& force, int row);
    void addPressure(int row);
    void addMotion(int row, State& state);
    void replace(const Load& load, int block);
    int blockHolding(const State& state, const Point& place) const;
    double zeroOf(const PrescribedMotion& motion) const;
    std::vector<const Table*> tables() const;

    const Model& model_;
    const Scene& scene_;
    int stage_ = -1;
    Loads loads_;
    LoadPoint start_;
    std::vector<LoadSource> forceSources_, pressureSources_, motionSources_;
    std::vector<Point> zero_;  // centroids at the last `zero_displacements`; empty: those of the start
};

}  // namespace keyblock
