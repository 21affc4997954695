// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/run_time.h"

#include <algorithm>

namespace keyblock {

namespace {

/// The latest time that anything of each stage bears; −1 for one that was not begun.
std::vector<double> reached(const RunSource& run) {
    std::vector<double> times(run.scene().stages.size(), -1.0);
    const auto see = [&](int stage, double time) {
        double& latest = times[static_cast<std::size_t>(stage)];
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
    bool anyStatic = false, anyDynamic = false;
    for (std::size_t stage = 0; stage < times.size(); ++stage) {
        if (times[stage] < 0.0) continue;
        const double from = end();
        stages_.push_back({static_cast<int>(stage), from, from + times[stage]});
        (run.scene().stages[stage].kind == StageKind::Dynamic ? anyDynamic : anyStatic) = true;
    }
    title_ = !anyStatic ? "time (s)" : !anyDynamic ? "pseudo-time" : "time (s), a static stage as 1";
}

double RunTime::at(int stage, double time) const {
    for (const StageSpan& span : stages_)
        if (span.stage == stage) return span.from + time;
    return end();
}

}  // namespace keyblock
