// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_run.h"

#include "solver/files/run_store/run_store.h"
#include "solver/scene/solved_blocks.h"

#include <algorithm>
#include <cassert>

namespace keyblock {

namespace {

constexpr std::size_t mostLoaded = 6;  // frames
constexpr std::size_t mostSamples = 400;  // diagnostic samples kept: twice the width of a strip in pixels

}  // namespace

LiveRun::LiveRun(std::filesystem::path store, const LiveStart& start)
    : store_(std::move(store)), scene_(start.scene),
      names_(keyblock::blockNames(*scene_)), columns_(start.columns),
      frames_(store_, scene_) {}

std::shared_ptr<LiveRun> LiveRun::opened(const std::filesystem::path& store) {
    const RunStore kept(store);
    auto run = std::make_shared<LiveRun>(
        store, LiveStart{std::make_shared<const Scene>(kept.scene()), kept.columns()});
    LiveFeed feed;
    feed.earlier(kept);
    run->append(feed.take());
    return run;
}

void LiveRun::append(LiveBatch batch) {
    for (const int stage : batch.stagesBegun)
        if (stages_.empty() || stages_.back().result.stage < stage) {
            stages_.push_back({});
            stages_.back().result.stage = stage;
        }
    for (StageResult& result : batch.stagesEnded)
        for (StageRecord& record : stages_)
            if (record.result.stage == result.stage) record = {result, true};
    if (!batch.events.empty()) {
        handedOut_ = nullptr;
        events_.insert(events_.end(), batch.events.begin(), batch.events.end());
    }
    history_.append(std::move(batch.history));
    heads_.insert(heads_.end(), batch.frames.begin(), batch.frames.end());
    if (batch.newest.frame) newest_ = std::move(batch.newest);
    if (batch.progress) progress_ = batch.progress;
    if (batch.health) addHealth(*batch.health);
}

/// Adds a sample. If there are too many, neighbouring pairs are merged, and each new sample covers twice as many steps.
void LiveRun::addHealth(const HealthSample& sample) {
    if (!health_.empty() && pendingJoins_ > 0 && health_.back().stage == sample.stage) {
        health_.back() = joined(health_.back(), sample);
        --pendingJoins_;
        return;
    }
    health_.push_back(sample);
    pendingJoins_ = joinedSteps_ - 1;
    if (health_.size() < mostSamples) return;
    std::vector<HealthSample> half;
    for (std::size_t i = 0; i < health_.size(); ++i) {
        if (i % 2 == 1 && half.back().stage == health_[i].stage) half.back() = joined(half.back(), health_[i]);
        else half.push_back(health_[i]);
    }
    health_ = std::move(half);
    joinedSteps_ *= 2;
}

std::shared_ptr<const std::vector<Event>> LiveRun::sharedEvents() const {
    if (!handedOut_) handedOut_ = std::make_shared<const std::vector<Event>>(events_);
    return handedOut_;
}

std::shared_ptr<const Frame> LiveRun::sharedFrame(std::size_t index) const {
    const std::scoped_lock lock(loading_);
    const auto found =
        std::find_if(loaded_.begin(), loaded_.end(), [&](const auto& loaded) { return loaded.first == index; });
    if (found != loaded_.end()) {
        loaded_.splice(loaded_.begin(), loaded_, found);
        return loaded_.front().second;
    }
    loaded_.emplace_front(index, std::make_shared<const Frame>(frames_.frame(index)));
    if (loaded_.size() > mostLoaded) loaded_.pop_back();
    return loaded_.front().second;
}

Moment::Moment(std::shared_ptr<const LiveRun> run, std::size_t index)
    : run_(std::move(run)), stages_(run_->stages()), events_(run_->sharedEvents()), heads_{run_->frames().at(index)}, index_(index) {
    if (run_->newest().stored == index) frame_ = run_->newest().frame;
}

Moment::Moment(std::shared_ptr<const LiveRun> run)
    : run_(std::move(run)), stages_(run_->stages()), events_(run_->sharedEvents()), frame_(run_->newest().frame) {
    assert(frame_);
    heads_ = {headOf(*frame_)};
}

RunSoFar::RunSoFar(std::shared_ptr<const LiveRun> run)
    : run_(std::move(run)), stages_(run_->stageList()), events_(run_->sharedEvents()), history_(run_->historyRows()),
      heads_(run_->frames()) {}

std::shared_ptr<const Frame> Moment::sharedFrame() const { return frame_ ? frame_ : run_->sharedFrame(index_); }

}  // namespace keyblock
