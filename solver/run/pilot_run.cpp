// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Time is that of this thread: a busy machine does not change it, and with one thread
// all work is done here.
#include "solver/run/pilot_run.h"

#include "solver/run/run.h"

#include <algorithm>
#include <ctime>

namespace keyblock {
namespace {

constexpr double lateFrom = 0.7;  // share of the time of a stage from which its pace is that at the end

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct PilotSample {
    double seconds = 0.0, time = 0.0;
    long steps = 0, passes = 0;
};

/// A sink that keeps the costs of the stages and none of their results.
class PilotSink : public Sink {
public:
    void begin(const Scene&, const HistoryColumns&) override {}
    void stageBegins(int stage) override {
        pilot.stages.push_back({stage});
        samples_.clear();
        began_ = threadSeconds();
    }
    void event(const Event&) override {}
    void history(const HistoryRow&) override {}
    void frame(const Frame&) override {}
    void stageEnds(const StageResult& result) override {
        PilotStage& stage = pilot.stages.back();
        stage.seconds = threadSeconds() - began_;
        stage.time = result.time;
        stage.steps = result.steps;
        stage.over = result.outcome != Outcome::Stopped;
        pilot.whole = stage.over;
        pilot.seconds += stage.seconds;
        addLate(stage);
    }

    void sample(const Progress& now) {
        samples_.push_back({threadSeconds() - began_, now.time, now.steps, now.passes});
    }

    PilotRun pilot;

private:
    void addLate(PilotStage& stage) const {
        if (samples_.empty()) return;
        const PilotSample& last = samples_.back();
        stage.passes = last.passes;
        const auto late = std::find_if(samples_.begin(), samples_.end(),
                                       [&](const PilotSample& s) { return s.seconds >= lateFrom * last.seconds; });
        stage.lateSeconds = last.seconds - late->seconds;
        stage.lateTime = last.time - late->time;
        stage.latePasses = last.passes - late->passes;
    }

    std::vector<PilotSample> samples_;  // of the current stage
    double began_ = 0.0;
};

}  // namespace

std::optional<PilotRun> pilotRun(const Scene& scene, double most, const std::atomic<bool>* stop) {
    PilotSink sink;
    Control control;
    const double began = threadSeconds();
    control.progress = [&](const Progress& now) {
        sink.sample(now);
        if ((stop && *stop) || threadSeconds() - began >= most) control.stop = true;
    };
    run(scene, sink, control, {1, nullptr});
    if (stop && *stop) return std::nullopt;
    return std::move(sink.pilot);
}

}  // namespace keyblock
