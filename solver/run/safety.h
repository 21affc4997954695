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

/// Runs the scene `reduced`, whose strengths are divided by `factor`, and passes the results to a sink, as `run` does.
using SafetyTrial = std::function<void(const Scene& reduced, double factor, Sink& sink)>;

/// The factor to try next: 1, then doubled or halved until a bracket is found, then the middle of the bracket. None if
/// the bracket is no wider than `tolerance`, if the smallest or largest factor has been tried without finding a
/// bracket, or if the last three runs gave no verdict.
/// \param lower largest factor found to be stable so far; null: none yet.
/// \param upper smallest factor found to be unstable so far; null: none yet.
/// \param undecided number of runs without a verdict since the last verdict. After one such run, the next factor is at
///        a quarter of the bracket; after two, at three quarters. Without a bracket, the factor is instead multiplied
///        by 0.9 after one such run and by 1.1 after two.
std::optional<double> nextSafetyFactor(std::optional<double> lower, std::optional<double> upper, double tolerance,
                                       std::size_t undecided = 0);

/// Finds the factor of safety to within `scene.safety.tolerance`. With frozen bolt forces, the first run, at factor 1,
/// has bolts; all other runs use the scene without bolts (frozen_bolts.h). If the scene is not stable at factor 1, the
/// search then ends, because there are no bolt forces in equilibrium to freeze.
/// \param trial runs a scene with reduced strengths.
/// \param report called after every run that was not stopped and did not reach a limit; may be empty.
/// \pre `checkScene(scene)` and `checkSafety(scene)` found no error.
SafetyFactor findSafetyFactor(const Scene& scene, const SafetyTrial& trial,
                              const std::function<void(const SafetyRun&)>& report = {});

}  // namespace keyblock
