// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Buffer between the thread of the run and the window: it collects everything since the
// window last read it. The solver holds the lock only to append data, and never waits
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

/// Solver diagnostics: the worst values over the steps since the previous sample.
struct HealthSample {
    int stage = 0;
    double time = 0.0;  // time of the last step within its stage
    long steps = 0;  // number of steps in the run so far
    long stepCuts = 0;  // time-step reductions in the stage so far
    StepHealth worst;
};

/// Combines two consecutive samples into one. If they belong to different stages, the result is `second`.
HealthSample joined(const HealthSample& first, const HealthSample& second);

/// The state of the model after a step.
struct ShownFrame {
    std::shared_ptr<const Frame> frame;
    std::optional<std::size_t> stored;  // index among the stored frames; none: the state is not stored
};

/// Data at the start of a run, new or resumed.
struct LiveStart {
    std::shared_ptr<const Scene> scene;  // the scene as solved, after cutting
    HistoryColumns columns;
};

struct LiveBatch {
    std::optional<LiveStart> start;  // if set, all earlier data are discarded
    std::vector<int> stagesBegun;
    std::vector<StageResult> stagesEnded;
    std::vector<Event> events;
    std::vector<HistoryRow> history;
    std::vector<FrameHead> frames;
    ShownFrame newest;  // latest state; `frame` is null if there is no newer one
    std::optional<Progress> progress;
    std::optional<HealthSample> health;
};

class LiveFeed {
public:
    /// Returns the data collected since the last call. Called by the window.
    LiveBatch take();

    // Called by the run's thread.
    void start(std::shared_ptr<const Scene> solved, const HistoryColumns& columns);
    void stageBegins(int stage);
    void stageEnds(const StageResult& result);
    void event(const Event& event);
    void history(const HistoryRow& row);
    /// Adds the head of a stored frame. If the window has called `take` since the last copy, also adds a copy of the
    /// frame.
    /// \param number index of the frame among the stored frames
    void frame(const Frame& frame, std::size_t number);
    void look(const Frame& frame);
    void progress(const Progress& progress);
    /// Replaces all data with the results that the store held before the run was resumed.
    /// \param until checkpoint from which the run resumes; later results are left out. Null: nothing is left out.
    void earlier(const RunSource& run, const Checkpoint* until = nullptr);

private:
    std::mutex mutex_;
    LiveBatch batch_;
    std::atomic<bool> frameWanted_{true};
};

/// Writes all results to a store before passing them to the feed, so that the window only shows data that are saved.
class LiveSink : public Sink {
public:
    /// \param store,feed must outlive this object. \param solved the scene as solved, i.e. cut into blocks.
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
