// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a run puts what it finds, as it finds it. The run store writes it to
// disk, a test keeps it in memory, the window draws it.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/scene.h"

namespace keyblock {

struct Checkpoint;

/// Called from the thread that runs, in order of time. A sink that cannot write
/// throws `CannotWrite`; the run then ends with what it has.
class Sink {
public:
    virtual ~Sink() = default;

    virtual void begin(const Scene& scene, const HistoryColumns& columns) = 0;
    /// In place of `begin`, for a sink that has the results up to a checkpoint: those after it are forgotten.
    virtual void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from);
    virtual void stageBegins(int stage) = 0;
    virtual void event(const Event& event) = 0;
    virtual void history(const HistoryRow& row) = 0;
    /// A frame closes everything before it: what came so far is safe once this returns.
    virtual void frame(const Frame& frame) = 0;
    virtual void stageEnds(const StageResult& result) = 0;
    /// Where the run can be taken up again, with what came before. A sink from which runs are not resumed ignores it.
    virtual void checkpoint(const Checkpoint&) {}
};

/// Keeps everything in memory.
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
