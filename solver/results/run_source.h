// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Common interface to the results of a run, whether kept in memory or in a store on
// disk. Tables, JSON output and figures are made from it. Frames are large, so they
// are listed first and loaded one at a time.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <cassert>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Data of a frame that are available without loading the frame.
struct FrameHead {
    int stage = 0;
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    long step = 0;
    Energy energy;
    long events = 0;  // number of events from the start of the run to this frame
};

FrameHead headOf(const Frame& frame);

/// A stage that has begun. If it has not ended (the run is in progress or was killed), `result.outcome` is not valid.
struct StageRecord {
    StageResult result;
    bool ended = false;
};

class RunSource {
public:
    virtual ~RunSource() = default;

    virtual const Scene& scene() const = 0;  // as run: cut, with the stages that may follow a collapse
    virtual const std::vector<std::string>& blockNames() const = 0;  // one per row of a frame's blocks
    virtual const HistoryColumns& columns() const = 0;
    virtual std::vector<StageRecord> stages() const = 0;
    virtual std::vector<Event> events() const = 0;  // in order of time
    virtual std::vector<HistoryRow> history() const = 0;  // in order of time
    virtual const std::vector<FrameHead>& frames() const = 0;  // in order of time

    /// Loads one frame.
    /// \pre `index` is less than `frames().size()`.
    virtual Frame frame(std::size_t index) const = 0;
};

/// Index of the stage with which a run continues after a stage with this result; none if the run ends. A stage that
/// only follows a collapse is skipped if there was no collapse. \param scene the scene as run.
std::optional<int> stageAfter(const Scene& scene, const StageResult& result);

/// Whether the run is complete after a stage with this result: the stage was the last one, or it became unstable and no
/// further stage is to be run. A run that was stopped, failed numerically or reached a limit is not complete.
/// \param scene the scene as run.
bool endsRun(const Scene& scene, const StageResult& result);

/// Whether the run is complete.
bool isFinished(const RunSource& run);

/// Whether a static stage with this outcome is unstable: it collapsed, or reached equilibrium only after large
/// displacements.
bool endedUnstable(Outcome outcome);

/// Whether a stage with this outcome ended as intended: in equilibrium, or at the end of its duration.
bool endedAsPlanned(Outcome outcome);

/// A run kept in memory. \pre the results outlive this object.
class MemoryRun : public RunSource {
public:
    MemoryRun(const Scene& scene, const Results& results);

    const Scene& scene() const override { return scene_; }
    const std::vector<std::string>& blockNames() const override { return names_; }
    const HistoryColumns& columns() const override { return results_.columns; }
    std::vector<StageRecord> stages() const override;
    std::vector<Event> events() const override { return results_.events; }
    std::vector<HistoryRow> history() const override { return results_.history; }
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override {
        assert(index < heads_.size());
        return results_.frames.at(index);
    }

private:
    Scene scene_;
    const Results& results_;
    std::vector<std::string> names_;
    std::vector<FrameHead> heads_;
};

}  // namespace keyblock
