// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run as the window sees it, while it goes on and afterwards alike: events,
// history and what is known of the frames in memory, the frames themselves in the
// store. The window's thread grows it and reads it; other threads get a `Moment`, or all
// there is so far.
#pragma once

#include "solver/files/stored_frames.h"
#include "ui/runs/history_log.h"
#include "ui/runs/live_feed.h"

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
    /// A run that begins into this store.
    LiveRun(std::filesystem::path store, const LiveStart& start);

    /// A run that a store holds. Reads all but its frames. \throws CannotRead
    static std::shared_ptr<LiveRun> opened(const std::filesystem::path& store);

    /// Takes what came; a batch with a start is for a new `LiveRun`.
    void append(LiveBatch batch);

    const Scene& scene() const override { return *scene_; }
    const std::vector<std::string>& blockNames() const override { return names_; }
    const HistoryColumns& columns() const override { return columns_; }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override { return events_; }
    std::vector<HistoryRow> history() const override { return history_.all(); }
    const std::vector<FrameHead>& frames() const override { return heads_; }
    Frame frame(std::size_t index) const override { return *sharedFrame(index); }

    // The same without copies.
    const std::vector<StageRecord>& stageList() const { return stages_; }
    const std::vector<Event>& eventList() const { return events_; }
    const HistoryLog& historyRows() const { return history_; }
    /// As they are now; they do not grow in the hands of who has them.
    std::shared_ptr<const std::vector<Event>> sharedEvents() const;

    /// The newest state, stored or not; null before the first, and of a run that was opened.
    const ShownFrame& newest() const { return newest_; }

    /// How the steps went, in a few hundred samples at most; empty of a run that was opened.
    const std::vector<HealthSample>& health() const { return health_; }
    const std::optional<Progress>& progress() const { return progress_; }

    /// A stored frame, from any thread; the last few are kept. \throws CannotRead
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
    mutable std::shared_ptr<const std::vector<Event>> handedOut_;  // the events, until there are more
    HistoryLog history_;
    std::vector<FrameHead> heads_;
    ShownFrame newest_;
    std::vector<HealthSample> health_;
    int joinedSteps_ = 1, pendingJoins_ = 0;  // samples of the feed in one of ours; in the last one so far
    std::optional<Progress> progress_;

    StoredFrames frames_;
    mutable std::mutex loading_;
    mutable std::list<std::pair<std::size_t, std::shared_ptr<const Frame>>> loaded_;  // the newest first
};

/// One moment of a run, which does not grow: what a picture of it is made from, on any thread.
class Moment : public RunSource {
public:
    /// A stored frame.
    Moment(std::shared_ptr<const LiveRun> run, std::size_t index);
    /// The run's newest state. \pre there is one.
    explicit Moment(std::shared_ptr<const LiveRun> run);

    const Scene& scene() const override { return run_->scene(); }
    const std::vector<std::string>& blockNames() const override { return run_->blockNames(); }
    const HistoryColumns& columns() const override { return run_->columns(); }
    std::vector<StageRecord> stages() const override { return stages_; }
    std::vector<Event> events() const override { return *events_; }
    std::vector<HistoryRow> history() const override { return {}; }
    const std::vector<FrameHead>& frames() const override { return heads_; }  // the one
    Frame frame(std::size_t) const override { return *sharedFrame(); }

    std::shared_ptr<const Frame> sharedFrame() const;

private:
    std::shared_ptr<const LiveRun> run_;  // for what does not grow, and for frames
    std::vector<StageRecord> stages_;
    std::shared_ptr<const std::vector<Event>> events_;
    std::vector<FrameHead> heads_;
    std::size_t index_ = 0;
    std::shared_ptr<const Frame> frame_;  // null: to be loaded
};

/// All that a run has, which does not grow: what its curves are made from, on any thread.
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
    Frame frame(std::size_t index) const override { return *run_->sharedFrame(index); }

private:
    std::shared_ptr<const LiveRun> run_;  // for what does not grow, and for frames
    std::vector<StageRecord> stages_;
    std::shared_ptr<const std::vector<Event>> events_;
    HistoryLog history_;
    std::vector<FrameHead> heads_;
};

}  // namespace keyblock
