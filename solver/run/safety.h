// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factor of safety by strength reduction: the scene is run repeatedly with its
// strengths divided by different factors, until a stable and an unstable factor
// lie close together.
#pragma once

#include "solver/run/failure_mode.h"
#include "solver/run/run.h"

#include <functional>
#include <optional>
#include <vector>

namespace keyblock {

/// Smallest and largest factors that are tried.
inline constexpr double leastSafety = 1e-3, mostSafety = 1e3;

/// One run with strengths divided by `factor`.
struct SafetyRun {
    double factor = 1.0;
    bool stands = false;  // stable: every stage ended in equilibrium
    StageResult end;  // the first stage that did not end in equilibrium, else the last stage
};

struct SafetyFactor {
    std::optional<double> lower;  // largest factor found to be stable, below `upper`
    std::optional<double> upper;  // smallest factor found to be unstable, above `lower`
    std::vector<SafetyRun> runs;  // in the order in which they were done
    std::optional<FailureMode> mode;  // failure mode of the run at `upper`
    std::optional<Outcome> cutShort;  // `Stopped`, `Limit` or `Undecided`, if the search ended early for that reason
    bool nothingToFreeze = false;  // bolt forces were to be frozen, but the scene fails with unreduced strengths
};

/// Runs a scene and passes the results to a sink, as `run` does.
using SafetyTrial = std::function<void(const Scene& reduced, double factor, Sink& sink)>;

/// The factor to try next: 1, then doubled or halved until a bracket is found, then the middle of the bracket. None
/// once the bracket is no wider than `tolerance`, the smallest or largest factor has been tried, or three runs in a row
/// gave no verdict.
/// \param undecided number of runs without a verdict since the last verdict. After one such run, the next factor is at
/// a quarter of the bracket; after two, at three quarters. Without a bracket, the factor that would be tried for
/// `undecided` = 0 is multiplied by 0.9 after one such run and by 1.1 after two.
std::optional<double> nextSafetyFactor(std::optional<double> lower, std::optional<double> upper, double tolerance,
                                       std::size_t undecided = 0);

/// Finds the factor of safety to within `scene.safety.tolerance`. With frozen bolt forces, all runs except the one at
/// factor 1 use the scene without bolts (frozen_bolts.h); if the scene is not stable at factor 1, the search ends,
/// because there are no bolt forces in equilibrium to freeze.
/// \pre `checkScene(scene)` and `checkSafety(scene)` found no error.
/// \param report called after every run, unless it was stopped or reached a limit; may be empty.
SafetyFactor findSafetyFactor(const Scene& scene, const SafetyTrial& trial,
                              const std::function<void(const SafetyRun&)>& report = {});

}  // namespace keyblock
