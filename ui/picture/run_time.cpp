// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/run_time.h"

#include "solver/results/result_names.h"

#include <algorithm>

namespace keyblock {

namespace {

constexpr double roomOfDynamic = 3.0;  // width of a dynamic stage; a static stage is as wide as its pseudo-time

/// The latest time in the data of each stage; −1 for a stage that was not started.
std::vector<double> reached(const RunSource& run) {
    std::vector<double> times(run.scene().stages.size(), -1.0);
    const auto see = [&](int stage, double time) {
        double& latest = times[stage];
        latest = std::max(latest, time);
    };
    for (const FrameHead& frame : run.frames()) see(frame.stage, frame.time);
    for (const HistoryRow& row : run.history()) see(row.stage, row.time);
    for (const Event& event : run.events()) see(event.stage, event.time);
    return times;
}

}  // namespace

RunTime::RunTime(const RunSource& run) {
    const std::vector<double> times = reached(run);
    const bool several = std::count_if(times.begin(), times.end(), [](double time) { return time >= 0.0; }) > 1;
    bool anyStatic = false, anyDynamic = false;
    for (std::size_t stage = 0; stage < times.size(); ++stage) {
        if (times[stage] < 0.0) continue;
        const bool dynamic = run.scene().stages[stage].kind == StageKind::Dynamic;
        const double from = end(), room = several && dynamic && times[stage] > 0.0 ? roomOfDynamic : times[stage];
        const int index = static_cast<int>(stage);
        stages_.push_back({index, stageName(run.scene(), index), from, from + room, times[stage]});
        (dynamic ? anyDynamic : anyStatic) = true;
    }
    const std::string each = several ? " of each stage" : "";
    title_ = anyDynamic ? "time" + each + (anyStatic ? " (s; static: pseudo-time)" : " (s)") : "pseudo-time" + each;
}

double RunTime::at(int stage, double time) const {
    for (const StageSpan& span : stages_)
        if (span.stage == stage)
            return span.from + (span.reached > 0.0 ? (span.to - span.from) * time / span.reached : 0.0);
    return end();
}

double RunTime::atTotal(double time) const {
    for (const StageSpan& span : stages_) {
        if (time <= span.reached || span.stage == stages_.back().stage) return at(span.stage, time);
        time -= span.reached;
    }
    return end();
}

}  // namespace keyblock
