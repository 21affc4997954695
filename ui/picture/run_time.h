// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis of time for a whole run. A run of one stage has its own time; where there
// are several, they stand one after the other with room by their kind, as on the
// window's time line, since a second of pseudo-time and eight milliseconds of shaking
// would not be seen on one scale.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"

#include <string>
#include <vector>

namespace keyblock {

class RunTime {
public:
    explicit RunTime(const RunSource& run);

    /// Stages that were begun, in order; each until the time it reached.
    const std::vector<StageSpan>& stages() const { return stages_; }
    double end() const { return stages_.empty() ? 0.0 : stages_.back().to; }

    /// Where a moment of a stage lies on the axis.
    double at(int stage, double time) const;

    /// Where a time lies that counts on through all stages.
    double atTotal(double time) const;

    /// What the axis is called.
    const std::string& title() const { return title_; }

private:
    std::vector<StageSpan> stages_;
    std::string title_;
};

}  // namespace keyblock
