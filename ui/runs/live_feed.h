// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Buffer between the run's thread and the window: everything since the window last read
// it. The solver appends under a lock that is held only for the append, and never waits
// for drawing.
#pragma once

#include "solver/results/run_source.h"
#include "solver/run/run.h"
#include "solver/run/sink.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace keyblock {

/// Worst values of the steps since the previous sample.
struct HealthSample {
    int stage = 0;
    double time = 0.0;  // within the stage, of the last step
    long steps = 0;  // in the run so far
    long stepCuts = 0;  // in the stage so far
    StepHealth worst;
};

/// Joins two consecutive samples.
HealthSample joined(const HealthSample& first, const HealthSample& second);

/// A state between two steps.
struct ShownFrame {
    std::shared_ptr<const Frame> frame;
    std::optional<std::size_t> stored;  // its number among stored frames, from 0; none: between two of them
};

/// The start of a run, new or resumed.
struct LiveStart {
    std::shared_ptr<const Scene> scene;  // as solved: cut
    HistoryColumns columns;
};

struct LiveBatch {
    std::optional<LiveStart> start;  // all earlier data are dropped
    std::vector<int> stagesBegun;
    std::vector<StageResult> stagesEnded;
    std::vector<Event> events;
    std::vector<HistoryRow> history;
    std::vector<FrameHead> frames;
    ShownFrame newest;  // null: no newer one
    std::optional<Progress> progress;
    std::optional<HealthSample> health;
};

class LiveFeed {
public:
    /// The data since the last call. Called by the window.
    LiveBatch take();

    // Called by the run's thread.
    void start(std::shared_ptr<const Scene> solved, const HistoryColumns& columns);
    void stageBegins(int stage);
    void stageEnds(const StageResult& result);
    void event(const Event& event);
    void history(const HistoryRow& row);
    /// Keeps a copy of the frame if the window has taken the previous one.
    void frame(const Frame& frame, std::size_t number);
    void look(const Frame& frame);
    void progress(const Progress& progress);
    /// Results that a store held before the run was resumed; null: all of them. Replaces earlier data.
    void earlier(const RunSource& run, const Checkpoint* until = nullptr);

private:
    std::mutex mutex_;
    LiveBatch batch_;
    std::atomic<bool> frameWanted_{true};
};

/// Passes everything to a store first, so that the window only sees data that are saved.
class LiveSink : public Sink {
public:
    /// Both must outlive this. \param solved the scene as solved.
    LiveSink(Sink& store, LiveFeed& feed, std::shared_ptr<const Scene> solved);

    void begin(const Scene& scene, const HistoryColumns& columns) override;
    void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) override;
    void stageBegins(int stage) override;
    void event(const Event& event) override;
    void history(const HistoryRow& row) override;
    void frame(const Frame& frame) override;
    void stageEnds(const StageResult& result) override;
    void checkpoint(const Checkpoint& checkpoint) override { store_.checkpoint(checkpoint); }

private:
    Sink& store_;
    LiveFeed& feed_;
    std::shared_ptr<const Scene> solved_;
    std::size_t rows_ = 0, frames_ = 0;
};

}  // namespace keyblock
