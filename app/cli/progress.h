// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shows the progress of a run on standard error, at most ten times a second: as a bar
// with the time remaining, or as JSON objects, one per line.
#pragma once

#include "app/cli/cli_commands.h"
#include "app/cli/json_answers.h"
#include "solver/run/run.h"
#include "solver/run/sink.h"

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace keyblock::cli {

/// Resolves `Automatic`: a bar if standard error is a terminal, otherwise none. Other kinds are returned unchanged.
ProgressKind chosenProgress(ProgressKind kind);

using Clock = std::chrono::steady_clock;

/// A sink that forwards everything to another sink and also shows progress.
class ProgressSink : public Sink {
public:
    /// \param scene the scene as solved, i.e. cut into blocks.
    /// \param label text shown before the name of the stage; may be empty.
    /// \pre `kind` is not `Automatic`; `next` outlives this object.
    ProgressSink(const Scene& scene, Sink& next, ProgressKind kind, std::string label = {});
    /// JSON: writes the last state if it has not been written yet. Bar: clears the bar.
    ~ProgressSink() override;
    ProgressSink(const ProgressSink&) = delete;
    ProgressSink& operator=(const ProgressSink&) = delete;

    void begin(const Scene& scene, const HistoryColumns& columns) override;
    void resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint& from) override;
    void stageBegins(int stage) override;
    void event(const Event& event) override;
    void history(const HistoryRow& row) override { next_.history(row); }
    void frame(const Frame& frame) override { next_.frame(frame); }
    void stageEnds(const StageResult& result) override;
    void checkpoint(const Checkpoint& checkpoint) override { next_.checkpoint(checkpoint); }

    /// Updates the display; to be called whenever the run reports its progress.
    void update(const Progress& progress);

    /// Wall-clock time [s] of each stage that has ended, by index of the stage.
    const std::map<int, double>& stageSeconds() const { return stageSeconds_; }

private:
    void tell();
    std::string barText(const ProgressLine& line) const;

    Scene scene_;  // as run
    const std::vector<std::string> blocks_;  // names of the blocks
    Sink& next_;
    ProgressKind kind_;
    std::string label_;
    Progress progress_;
    std::optional<double> startFraction_;  // fraction completed before this run started or resumed
    bool unreported_ = false;
    std::optional<Event> lastEvent_;
    Clock::time_point runStart_;
    Clock::time_point stageStart_;
    std::optional<Clock::time_point> lastReport_;
    std::map<int, double> stageSeconds_;
};

}  // namespace keyblock::cli
