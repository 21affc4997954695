// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Between the thread that runs and the window: what came since the window last
// asked. The solver puts values down under a lock that is held for as long as an
// append takes, and never waits for a picture to be drawn.
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

/// How the steps went since the sample before: the worst of each.
struct HealthSample {
    int stage = 0;
    double time = 0.0;  // within the stage, of the last of them
    long steps = 0;  // in the run until then
    long stepCuts = 0;  // in the stage until then
    StepHealth worst;
};

/// Joins two samples that follow one another.
HealthSample joined(const HealthSample& first, const HealthSample& second);

/// A state between two steps.
struct ShownFrame {
    std::shared_ptr<const Frame> frame;
    std::optional<std::size_t> stored;  // its number among the stored ones, from 0; none: it lies between them
};

/// How a run begins, or goes on.
struct LiveStart {
    std::shared_ptr<const Scene> scene;  // as it is solved: cut
    HistoryColumns columns;
};

struct LiveBatch {
    std::optional<LiveStart> start;  // everything before it is forgotten
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
    /// What came since the last call. From the window.
    LiveBatch take();

    // From the thread that runs.
    void start(std::shared_ptr<const Scene> solved, const HistoryColumns& columns);
    void stageBegins(int stage);
    void stageEnds(const StageResult& result);
    void event(const Event& event);
    void history(const HistoryRow& row);
    /// Keeps a copy of the frame where the window has taken the one before.
    void frame(const Frame& frame, std::size_t number);
    void look(const Frame& frame);
    void progress(const Progress& progress);
    /// Results that a store held before the run went on; null: all of them. In place of what came before.
    void earlier(const RunSource& run, const Checkpoint* until = nullptr);

private:
    std::mutex mutex_;
    LiveBatch batch_;
    std::atomic<bool> frameWanted_{true};
};

/// Passes everything on to a store first, so that what the window hears of is safe.
class LiveSink : public Sink {
public:
    /// Both outlive this. \param solved the scene as it is solved.
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
