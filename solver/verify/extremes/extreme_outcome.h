// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs a scene at an extreme and decides how it ended.
#pragma once

#include "solver/verify/extremes/extremes.h"
#include "solver/verify/extremes/findings.h"
#include "solver/verify/readings.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// What a scene gave: the errors and warnings of its check, its results, or the reason why there are none.
struct ExtremeOutcome {
    std::string refused;  // first error of the check; empty: none
    std::string broken;  // text of an exception; empty: none
    std::string stopped;  // message of a stage that failed or reached a limit; empty: none
    std::vector<std::string> warnings;  // of the check and of the run
    std::optional<Solved> solved;
};

/// Checks and runs a scene.
ExtremeOutcome runExtreme(const Scene& scene);

/// How a run with these findings ended. \param ordinary warnings that the scene gets under ordinary conditions, too.
ExtremeRun judged(const ExtremeOutcome& outcome, const Findings& findings, const std::vector<std::string>& ordinary);

/// Checks that hold for every run, also for one that was stopped: finite numbers and no negative energy.
void judgeNumbers(const Solved& solved, Findings& findings);

/// The energy balance of a run in motion closes.
void judgeEnergy(const Solved& solved, Findings& findings);

}  // namespace keyblock
