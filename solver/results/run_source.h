// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One way to look at a run, whether it is kept in memory or in a store on disk:
// tables, answers and figures are made from this. Frames are large, so they are
// listed first and loaded one at a time.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// What is known of a frame without loading it.
struct FrameHead {
    int stage = 0;
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    long step = 0;
    Energy energy;
    long events = 0;  // of the run until then
};

FrameHead headOf(const Frame& frame);

/// A stage that was begun; one that never ended (the run is still in progress, or was killed) has no outcome.
struct StageRecord {
    StageResult result;
    bool ended = false;
};

class RunSource {
public:
    virtual ~RunSource() = default;

    virtual const Scene& scene() const = 0;  // as it was run: cut, and with what may follow a collapse
    virtual const std::vector<std::string>& blockNames() const = 0;  // rows of a frame's blocks
    virtual const HistoryColumns& columns() const = 0;
    virtual std::vector<StageRecord> stages() const = 0;
    virtual std::vector<Event> events() const = 0;  // in order of time
    virtual std::vector<HistoryRow> history() const = 0;  // in order of time
    virtual const std::vector<FrameHead>& frames() const = 0;  // in order of time

    /// Loads one frame.
    /// \pre `index` counts within `frames()`.
    virtual Frame frame(std::size_t index) const = 0;
};

/// The stage with which a run continues after one that ended like this, if any: not after a collapse that says to stop,
/// and only after a collapse what follows that. \param scene as it is run.
std::optional<int> stageAfter(const Scene& scene, const StageResult& result);

/// Whether a run that ends a stage like this is done: the scene's last stage, or a collapse after which it says to stop.
/// A run that was stopped, failed or came to a limit is not. \param scene as it is run.
bool endsRun(const Scene& scene, const StageResult& result);

/// Whether nothing is left to do of a run.
bool isFinished(const RunSource& run);

/// Whether a static stage showed that something does not stay where it is: a collapse, or rest elsewhere.
bool endedUnstable(Outcome outcome);

/// Whether a stage came to where it was to come: to rest, or to the end of its time.
bool endedAsPlanned(Outcome outcome);

/// A run kept in memory. The results must outlive it.
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
    Frame frame(std::size_t index) const override { return results_.frames.at(index); }

private:
    Scene scene_;
    const Results& results_;
    std::vector<std::string> names_;
    std::vector<FrameHead> heads_;
};

}  // namespace keyblock
