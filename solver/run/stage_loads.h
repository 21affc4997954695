// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loads of a run as its stages bring them: what a stage puts on stays with
// its last value in the stages after it, until one of them puts something else
// in its place.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// The load or motion of a stage that something acts by.
struct LoadSource {
    int stage = -1, row = -1;
    bool replaced = false;  // by a later stage: nothing acts any more
};

/// What acts, with what the stages before have left.
struct LoadMemory {
    int stage = -1;
    Loads loads;
    LoadPoint start;  // what acted when the stage began
    std::vector<LoadSource> forceSources, pressureSources, motionSources;  // rows of Loads
    std::vector<int> wallStages;  // that excavated, per row of Loads::walls; −1: of a viscous boundary
    std::vector<Point> zero;  // centroids at the last `zero_displacements`; empty: those of the start
};

class StageLoads {
public:
    /// \param memory kept by the caller, who may put back what it was.
    StageLoads(const Model& model, const Scene& scene, LoadMemory& memory)
        : model_(model), scene_(scene), memory_(memory) {}

    /// Adds the loads and motions of a stage. A motion takes the place of an earlier one on its block, a load that of
    /// one of an earlier stage at the same place.
    void begin(int stage, State& state);

    /// Keeps the forces of excavated rock, to be released over this stage and later ones. \pre a static stage has
    /// begun.
    void hold(const std::vector<WallForce>& walls);

    /// Viscous boundaries of this stage, and the forces of what held them before, which stay as long as they do.
    void quieten(const std::vector<Dashpot>& dashpots, const std::vector<WallForce>& kept);

    /// Forgets loads and motions of what is not there any more.
    void forgetAbsent(const State& state);

    const Loads& loads() const { return memory_.loads; }

    /// What acted when the stage began.
    const LoadPoint& start() const { return memory_.start; }

    /// What acts at `time` of the stage.
    LoadPoint at(double time) const;

    /// Times in (0, 1) at which a table of this stage turns.
    std::vector<double> turns() const;

    /// True where anything of this stage changes after its time 0.
    bool varies() const;

    /// Keeps what acts at the stage's end for the next.
    void end(const LoadPoint& reached) { memory_.start = reached; }

private:
    const Stage& stage() const { return stageAt(memory_.stage); }
    const Stage& stageAt(int index) const { return scene_.stages[static_cast<std::size_t>(index)]; }
    const Load& loadOf(const LoadSource& source) const;
    void addLoad(int row, const State& state);
    void addSpread(int row, int block);
    void addForce(const PointForce& force, int row);
    void addPressure(int row, const State& state);
    bool keepsAcceleration() const;
    Point bodyAccelerationAt(double time) const;
    double wallAtEnd(std::size_t wall) const;
    void addOpenings(double time, LoadPoint& point) const;
    void addMotion(int row, State& state);
    void replace(const Load& load, int block);
    void forgetReplaced();
    int blockHolding(const State& state, const Point& place) const;
    double zeroOf(const PrescribedMotion& motion) const;
    std::vector<const Table*> tables() const;

    const Model& model_;
    const Scene& scene_;
    LoadMemory& memory_;
};

}  // namespace keyblock
