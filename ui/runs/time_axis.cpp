// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/time_axis.h"

#include <algorithm>
#include <cassert>

namespace keyblock {

namespace {

constexpr double roomOfStatic = 1.0, roomOfDynamic = 3.0;

bool isDynamic(const Stage& stage) { return stage.kind == StageKind::Dynamic; }

}  // namespace

TimeAxis::TimeAxis(const Scene& scene) {
    double all = 0.0;
    for (const Stage& stage : scene.stages) all += isDynamic(stage) ? roomOfDynamic : roomOfStatic;
    double at = 0.0;
    for (std::size_t s = 0; s < scene.stages.size(); ++s) {
        const bool dynamic = isDynamic(scene.stages[s]);
        const double room = (dynamic ? roomOfDynamic : roomOfStatic) / all;
        const double duration = dynamic && scene.stages[s].duration > 0.0 ? scene.stages[s].duration : 1.0;
        spans_.push_back({static_cast<int>(s), at, at + room, duration});
        at += room;
    }
    if (!spans_.empty()) spans_.back().to = 1.0;
}

double TimeAxis::at(int stage, double time) const {
    if (stage < 0 || static_cast<std::size_t>(stage) >= spans_.size()) return 1.0;
    const Span& span = spans_[stage];
    return span.from + (span.to - span.from) * std::clamp(time / span.duration, 0.0, 1.0);
}

TimeAxis::Moment TimeAxis::momentAt(double place) const {
    assert(!isEmpty());
    const auto found = std::find_if(spans_.begin(), spans_.end(), [&](const Span& span) { return place < span.to; });
    const Span& span = found == spans_.end() ? spans_.back() : *found;
    const double share = std::clamp((place - span.from) / (span.to - span.from), 0.0, 1.0);
    return {span.stage, share * span.duration};
}

}  // namespace keyblock
