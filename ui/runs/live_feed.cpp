// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/live_feed.h"

#include "solver/run/checkpoint.h"

#include <algorithm>
#include <utility>

namespace keyblock {

HealthSample joined(const HealthSample& first, const HealthSample& second) {
    HealthSample both = second;
    if (first.stage != second.stage) return both;
    const StepHealth& a = first.worst;
    StepHealth& worst = both.worst;
    if (a.passes > worst.passes) worst.passes = a.passes, worst.worst = a.worst;
    if (a.penetrationRatio > worst.penetrationRatio)
        worst.penetrationRatio = a.penetrationRatio, worst.penetrated = a.penetrated;
    worst.residual = std::max(a.residual, worst.residual);
    return both;
}

LiveBatch LiveFeed::take() {
    const std::scoped_lock lock(mutex_);
    frameWanted_ = true;
    return std::exchange(batch_, {});
}

void LiveFeed::start(std::shared_ptr<const Scene> solved, const HistoryColumns& columns) {
    const std::scoped_lock lock(mutex_);
    batch_ = {};
    batch_.start = LiveStart{std::move(solved), columns};
}

void LiveFeed::stageBegins(int stage) {
    const std::scoped_lock lock(mutex_);
    batch_.stagesBegun.push_back(stage);
}

void LiveFeed::stageEnds(const StageResult& result) {
    const std::scoped_lock lock(mutex_);
    batch_.stagesEnded.push_back(result);
}

void LiveFeed::event(const Event& event) {
    const std::scoped_lock lock(mutex_);
    batch_.events.push_back(event);
}

void LiveFeed::history(const HistoryRow& row) {
    const std::scoped_lock lock(mutex_);
    batch_.history.push_back(row);
}

void LiveFeed::frame(const Frame& frame, std::size_t number) {
    const FrameHead head = headOf(frame);
    std::shared_ptr<const Frame> copy;
    if (frameWanted_.exchange(false)) copy = std::make_shared<const Frame>(frame);
    const std::scoped_lock lock(mutex_);
    batch_.frames.push_back(head);
    if (copy) batch_.newest = {std::move(copy), number};
}

void LiveFeed::look(const Frame& frame) {
    auto copy = std::make_shared<const Frame>(frame);
    const std::scoped_lock lock(mutex_);
    batch_.newest = {std::move(copy), std::nullopt};
}

void LiveFeed::progress(const Progress& progress) {
    const HealthSample sample{progress.stage, progress.time, progress.steps, progress.stepCuts, progress.step};
    const std::scoped_lock lock(mutex_);
    batch_.progress = progress;
    batch_.health = batch_.health ? joined(*batch_.health, sample) : sample;
}

void LiveFeed::earlier(const RunSource& run, const Checkpoint* until) {
    LiveBatch batch;
    batch.events = run.events();
    batch.history = run.history();
    batch.frames = run.frames();
    for (const StageRecord& record : run.stages()) {
        const int stage = record.result.stage;
        if (until && (stage > until->stage || (stage == until->stage && !until->begun))) continue;
        batch.stagesBegun.push_back(stage);
        if (record.ended && !(until && stage == until->stage)) batch.stagesEnded.push_back(record.result);
    }
    if (until) {
        const auto keep = [](auto& rows, long count) {
            rows.resize(std::min(rows.size(), static_cast<std::size_t>(count)));
        };
        keep(batch.events, until->written.events);
        keep(batch.history, until->written.historyRows);
        keep(batch.frames, until->written.frames);
    }
    const std::scoped_lock lock(mutex_);
    batch.start = std::move(batch_.start);
    batch_ = std::move(batch);
}

LiveSink::LiveSink(Sink& store, LiveFeed& feed, std::shared_ptr<const Scene> solved)
    : store_(store), feed_(feed), solved_(std::move(solved)) {}

void LiveSink::begin(const Scene& scene, const HistoryColumns& columns) {
    store_.begin(scene, columns);
    feed_.start(solved_, columns);
}

void LiveSink::resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) {
    store_.resume(scene, columns, from);
    rows_ = static_cast<std::size_t>(from.written.historyRows);
    frames_ = static_cast<std::size_t>(from.written.frames);
}

void LiveSink::stageBegins(int stage) {
    store_.stageBegins(stage);
    feed_.stageBegins(stage);
}

void LiveSink::event(const Event& event) {
    store_.event(event);
    Event indexed = event;
    indexed.historyRow = static_cast<long>(rows_) - 1;
    feed_.event(indexed);
}

void LiveSink::history(const HistoryRow& row) {
    store_.history(row);
    ++rows_;
    feed_.history(row);
}

void LiveSink::frame(const Frame& frame) {
    store_.frame(frame);
    feed_.frame(frame, frames_++);
}

void LiveSink::stageEnds(const StageResult& result) {
    store_.stageEnds(result);
    feed_.stageEnds(result);
}

}  // namespace keyblock
