// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loads of a run, stage by stage. A load applied in one stage keeps its final
// value in the following stages until one of them replaces it.
#pragma once

#include "solver/engine/model/loads.h"
#include "solver/engine/model/state.h"
#include "solver/scene/scene.h"

namespace keyblock {

/// The load or motion in the scene from which an applied force, pressure or motion originates.
struct LoadSource {
    int stage = -1, row = -1;  // row in the stage's list of loads or motions
    bool replaced = false;  // replaced by a later stage, so it no longer acts
};

/// Active loads, including those left by earlier stages; plain values, part of the checkpoint.
struct LoadMemory {
    int stage = -1;
    Loads loads;
    LoadPoint start;  // load values at the start of the stage
    std::vector<LoadSource> forceSources, pressureSources, motionSources;  // one per row of the lists in `Loads`
    std::vector<int> wallStages;  // stage of the excavation for each row of Loads::walls; −1: a viscous boundary
    std::vector<Point> zero;  // centroids at the last `zero_displacements`; empty: use those at the start
};

class StageLoads {
public:
    /// \param memory owned by the caller; to resume a run, the caller overwrites it.
    StageLoads(const Model& model, const Scene& scene, LoadMemory& memory)
        : model_(model), scene_(scene), memory_(memory) {}

    /// Adds the loads and motions of the stage with index `stage`. A motion replaces an earlier motion of the same
    /// block; a load replaces a load of an earlier stage at the same position.
    void begin(int stage, State& state);

    /// Adds the forces that excavated rock exerted on the remaining rock. They are released during this stage and later
    /// ones. \pre the stage that has begun releases such forces: it is static or has `relaxation`.
    void hold(const std::vector<WallForce>& walls);

    /// Sets the viscous boundaries of this stage.
    /// \param kept the reactions of the supports that the viscous boundaries replace; they act as forces for as long as
    ///        these boundaries exist.
    void quieten(const std::vector<Dashpot>& dashpots, const std::vector<WallForce>& kept);

    /// Deletes the loads and motions of blocks and bolts that are no longer in the model.
    void forgetAbsent(const State& state);

    const Loads& loads() const { return memory_.loads; }

    /// Load values at the start of the stage.
    const LoadPoint& start() const { return memory_.start; }

    /// Load values at `time` within the stage.
    LoadPoint at(double time) const;

    /// Pseudo-times in (0, 1) at which the load and motion tables of this stage have entries.
    std::vector<double> turns() const;

    /// True if any load or motion changes during this stage after time 0.
    bool varies() const;

    /// Stores the load values reached at the end of the stage for the next one.
    void end(const LoadPoint& reached) { memory_.start = reached; }

private:
    const Stage& stage() const { return stageAt(memory_.stage); }
    const Stage& stageAt(int index) const { return scene_.stages[index]; }
    const Load& loadOf(const LoadSource& source) const;
    void addWalls(const std::vector<WallForce>& walls, int stage);
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
