// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A single time axis for a whole run. If a run has one stage, the axis shows the time
// of that stage. Several stages are placed one after another with widths that depend on
// their kind, as on the window's timeline, because a pseudo-time of 1 and 8 ms of
// shaking cannot share a scale.
#pragma once

#include "solver/results/run_source.h"
#include "ui/picture/chart.h"

#include <string>
#include <vector>

namespace keyblock {

class RunTime {
public:
    explicit RunTime(const RunSource& run);

    /// Stages that have started, in order. Each interval extends to the latest time that the stage has reached.
    const std::vector<StageSpan>& stages() const { return stages_; }
    double end() const { return stages_.empty() ? 0.0 : stages_.back().to; }

    /// Axis position of a time that is counted from the start of the stage; the end of the axis if the stage has not
    /// started.
    double at(int stage, double time) const;

    /// Axis position of a time that is counted from the start of the first stage and accumulated over all stages.
    double atTotal(double time) const;

    /// Title of the axis.
    const std::string& title() const { return title_; }

private:
    std::vector<StageSpan> stages_;
    std::string title_;
};

}  // namespace keyblock
