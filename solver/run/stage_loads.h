// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loads of a run as its stages bring them: what a stage puts on stays with
// its last value in the stages after it.
#pragma once

#include "solver/engine/step_build.h"
#include "solver/scene/scene.h"

namespace keyblock {

class StageLoads {
public:
    StageLoads(const Model& model, const Scene& scene) : model_(model), scene_(scene) {}

    /// Adds the loads and motions of a stage; a motion takes the place of an earlier one on its block.
    void begin(const Stage& stage, State& state);

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
    void addLoad(const Load& load, const State& state);
    void addSpread(const Load& load, int block);
    void addForce(const PointForce& force, const Load& load);
    void addPressure(const Load& load, const State& state);
    void addMotion(const Motion& motion, State& state);
    int blockHolding(const State& state, const Point& place) const;

    const Model& model_;
    const Scene& scene_;
    Loads loads_;
    LoadPoint start_;
    // a table per load and motion; null where it is of an earlier stage and keeps its value
    std::vector<const Table*> forceTables_, pressureTables_, motionTables_;
};

}  // namespace keyblock
