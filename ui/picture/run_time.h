// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One axis of time for a whole run: stages stand one after the other, seconds of
// dynamic ones and the pseudo-time of static ones alike.
#pragma once

#include "solver/results/run_source.h"

#include <string>
#include <vector>

namespace keyblock {

struct StageSpan {
    int stage = 0;
    double from = 0.0, to = 0.0;  // on the axis
};

class RunTime {
public:
    explicit RunTime(const RunSource& run);

    /// Stages that were begun, in order; each as long as the time it reached.
    const std::vector<StageSpan>& stages() const { return stages_; }
    double end() const { return stages_.empty() ? 0.0 : stages_.back().to; }

    /// Where a moment of a stage lies on the axis.
    double at(int stage, double time) const;

    /// What the axis is called.
    const std::string& title() const { return title_; }

private:
    std::vector<StageSpan> stages_;
    std::string title_;
};

}  // namespace keyblock
