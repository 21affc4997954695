// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis of time for a whole run. A run of one stage has its own time; several stages
// follow one another with widths by their kind, as on the window's timeline, since a
// second of pseudo-time and eight milliseconds of shaking cannot be shown on one scale.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"

#include <string>
#include <vector>

namespace keyblock {

class RunTime {
public:
    explicit RunTime(const RunSource& run);

    /// Stages that were started, in order; each up to the time it reached.
    const std::vector<StageSpan>& stages() const { return stages_; }
    double end() const { return stages_.empty() ? 0.0 : stages_.back().to; }

    /// Position of a time of a stage on the axis.
    double at(int stage, double time) const;

    /// Position of a time counted through all stages.
    double atTotal(double time) const;

    /// Title of the axis.
    const std::string& title() const { return title_; }

private:
    std::vector<StageSpan> stages_;
    std::string title_;
};

}  // namespace keyblock
