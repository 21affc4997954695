// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Receiver of the results of a run as they are produced. The run store writes them
// to disk, a test keeps them in memory, the window draws them.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

struct Checkpoint;

/// Receives the results of a run. Its functions are called from the thread of the run, in order of time. A sink that
/// cannot write throws `CannotWrite`, which ends the run.
class Sink {
public:
    virtual ~Sink() = default;

    virtual void begin(const Scene& scene, const HistoryColumns& columns) = 0;
    /// Called instead of `begin` for a sink that already has the results up to the checkpoint `from`. Any results after
    /// the checkpoint are discarded.
    virtual void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from);
    virtual void stageBegins(int stage) = 0;
    virtual void event(const Event& event) = 0;
    virtual void history(const HistoryRow& row) = 0;
    /// Stores a frame. Once this function returns, all results received so far are safely stored.
    virtual void frame(const Frame& frame) = 0;
    virtual void stageEnds(const StageResult& result) = 0;
    /// Receives a checkpoint. The run can be resumed from it and the results so far. Sinks that do not support resuming
    /// ignore checkpoints.
    virtual void checkpoint(const Checkpoint&) {}
};

/// A sink that keeps all results in memory.
class MemorySink : public Sink {
public:
    void begin(const Scene&, const HistoryColumns& columns) override { results.columns = columns; }
    void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) override;
    void stageBegins(int) override {}
    void event(const Event& event) override {
        results.events.push_back(event);
        results.events.back().historyRow = static_cast<long>(results.history.size()) - 1;
    }
    void history(const HistoryRow& row) override { results.history.push_back(row); }
    void frame(const Frame& frame) override { results.frames.push_back(frame); }
    void stageEnds(const StageResult& result) override { results.stages.push_back(result); }

    Results results;
};

}  // namespace keyblock
