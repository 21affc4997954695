// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a sweep is.
#pragma once

#include "solver/study/sweep_folder.h"

#include <array>
#include <string>
#include <vector>

namespace keyblock {

struct SweepStatus {
    long cases = 0;
    long finished = 0, running = 0, interrupted = 0;  // the others have not begun
    std::array<long, 6> outcomes{};  // finished cases, by `CaseOutcome`
    long fails = 0, undecided = 0;  // finished cases that fail by the criterion, or for which it is not known
    bool hasCriterion = false;
    double cpuSeconds = 0.0;  // of the finished cases
    std::vector<std::string> damaged;  // summaries that cannot be read, with the reason

    long waiting() const { return cases - finished - running - interrupted; }
};

/// Numbers of the cases that have begun, in order.
std::vector<long> begunCases(const std::filesystem::path& sweep);

SweepStatus statusOf(const Sweep& sweep, std::size_t quantities);

}  // namespace keyblock
