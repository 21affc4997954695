// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run in progress or finished, as the window shows it: events, history and frame
// headers in memory, the frames themselves in the store. Only the window's thread
// appends to it and reads it; other threads use snapshots, `Moment` or `RunSoFar`.
#pragma once

#include "solver/files/run_store/stored_frames.h"
#include "ui/runs/history_log.h"
#include "ui/runs/live_feed.h"

#include <cassert>
#include <cstddef>
#include <filesystem>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

class LiveRun : public RunSource {
public:
    /// Creates a new run whose results are written to this store.
    LiveRun(std::filesystem::path store, const LiveStart& start);

    /// Reads a run from a store; its frames are read later, one by one. \throws CannotRead
    static std::shared_ptr<LiveRun> opened(const std::filesystem::path& store);

    /// Appends a batch of data that belongs to this run. A batch whose `start` is set belongs to a new `LiveRun`.
    void append(LiveBatch batch);

    const Scene& scene() const override { return *scene_; }
    const std::vector<std::string>& blockNames() const override { return names_; }
    const HistoryColumns& columns() const override { return columns_; }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override { return events_; }
    std::vector<HistoryRow> history() const override { return history_.all(); }
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override { return *sharedFrame(index); }

    // Access without copying.
    const std::vector<StageRecord>& stageList() const { return stages_; }
    const std::vector<Event>& eventList() const { return events_; }
    const HistoryLog& historyRows() const { return history_; }
    /// Snapshot of the events so far. Later events are not added to the snapshot.
    std::shared_ptr<const std::vector<Event>> sharedEvents() const;

    /// The latest state, whether it is stored or not. Its frame is null before the first state and for a run opened
    /// from a file.
    const ShownFrame& newest() const { return newest_; }

    /// Solver diagnostics of the steps in chronological order, combined into at most a few hundred samples; empty for a
    /// run opened from a file.
    const std::vector<HealthSample>& health() const { return health_; }
    const std::optional<Progress>& progress() const { return progress_; }

    /// The stored frame with this index. Can be called from any thread. The most recently used frames stay in memory.
    /// \throws CannotRead
    std::shared_ptr<const Frame> sharedFrame(std::size_t index) const;

    const std::filesystem::path& store() const { return store_; }

private:
    void addHealth(const HealthSample& sample);

    std::filesystem::path store_;
    std::shared_ptr<const Scene> scene_;
    std::vector<std::string> names_;
    HistoryColumns columns_;
    std::vector<StageRecord> stages_;
    std::vector<Event> events_;
    mutable std::shared_ptr<const std::vector<Event>> handedOut_;  // copy of the events, until more are appended
    HistoryLog history_;
    std::vector<FrameHead> heads_;
    ShownFrame newest_;
    std::vector<HealthSample> health_;
    int joinedSteps_ = 1, pendingJoins_ = 0;  // samples combined per entry of `health_`; still to add to the last
    std::optional<Progress> progress_;

    StoredFrames frames_;
    mutable std::mutex loading_;
    mutable std::list<std::pair<std::size_t, std::shared_ptr<const Frame>>> loaded_;  // most recently used first
};

/// Snapshot of a run at one time, from which any thread can make drawings.
class Moment : public RunSource {
public:
    /// Snapshot of the stored frame with this index.
    Moment(std::shared_ptr<const LiveRun> run, std::size_t index);
    /// Snapshot of the latest state of the run. \pre the state exists.
    explicit Moment(std::shared_ptr<const LiveRun> run);

    const Scene& scene() const override { return run_->scene(); }
    const std::vector<std::string>& blockNames() const override { return run_->blockNames(); }
    const HistoryColumns& columns() const override { return run_->columns(); }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override { return *events_; }
    std::vector<HistoryRow> history() const override { return {}; }
    const std::vector<FrameHead>& frames() const override { return heads_; }  // of this frame
    Frame frame([[maybe_unused]] std::size_t index) const override {
        assert(index < heads_.size());
        return *sharedFrame();
    }

    std::shared_ptr<const Frame> sharedFrame() const;

private:
    std::shared_ptr<const LiveRun> run_;  // for data that do not change, and to load frames
    std::vector<StageRecord> stages_;
    std::shared_ptr<const std::vector<Event>> events_;
    std::vector<FrameHead> heads_;
    std::size_t index_ = 0;
    std::shared_ptr<const Frame> frame_;  // null: not loaded yet
};

/// Snapshot of all results of a run so far, from which any thread can draw curves.
class RunSoFar : public RunSource {
public:
    explicit RunSoFar(std::shared_ptr<const LiveRun> run);

    const Scene& scene() const override { return run_->scene(); }
    const std::vector<std::string>& blockNames() const override { return run_->blockNames(); }
    const HistoryColumns& columns() const override { return run_->columns(); }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override { return *events_; }
    std::vector<HistoryRow> history() const override { return history_.all(); }
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override {
        assert(index < heads_.size());
        return *run_->sharedFrame(index);
    }

private:
    std::shared_ptr<const LiveRun> run_;  // for data that do not change, and to load frames
    std::vector<StageRecord> stages_;
    std::shared_ptr<const std::vector<Event>> events_;
    HistoryLog history_;
    std::vector<FrameHead> heads_;
};

}  // namespace keyblock
