// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factor of safety by strength reduction: the scene is run again and again with
// its strengths divided by a factor, until a stable and an unstable one
// lie close together.
#pragma once

#include "solver/run/failure_mode.h"
#include "solver/run/run.h"

#include <functional>
#include <optional>
#include <vector>

namespace keyblock {

/// Beyond these no bracket is looked for.
inline constexpr double leastSafety = 1e-3, mostSafety = 1e3;

/// One run with strengths divided by `factor`.
struct SafetyRun {
    double factor = 1.0;
    bool stands = false;  // every stage ended in equilibrium
    StageResult end;  // the stage that decides: the first unstable one, else the last
};

struct SafetyFactor {
    std::optional<double> lower;  // largest factor found to be stable, below `upper`
    std::optional<double> upper;  // smallest factor found to be unstable, above `lower`
    std::vector<SafetyRun> runs;  // in the order in which they were done
    std::optional<FailureMode> mode;  // of the run at `upper`
    std::optional<Outcome> cutShort;  // `Stopped`, `Limit` or `Undecided`: the last run came to no answer
    bool nothingToFreeze = false;  // bolt forces were to be frozen, but the scene fails with its own strengths
};

/// Runs a scene into a sink, as `run` does.
using SafetyTrial = std::function<void(const Scene& reduced, double factor, Sink& sink)>;

/// The factor to try next: 1, then doubled or halved until there are both ends, then their middle; none when they are
/// `tolerance` apart, or at the last factor that is tried. \param undecided runs between these ends that came to no
/// verdict: the next is taken a quarter of the bracket away from the first, then three quarters, or a tenth less and
/// more where there is no bracket.
std::optional<double> nextSafetyFactor(std::optional<double> lower, std::optional<double> upper, double tolerance,
                                       std::size_t undecided = 0);

/// Looks for the factor to `scene.safety.tolerance`. Where bolt forces are frozen, all runs but the one at 1 are of
/// scenes without bolts (frozen_bolts.h), and a scene that fails at 1 ends the search, because it has no bolt forces in
/// equilibrium.
/// \pre `checkScene(scene)` and `checkSafety(scene)` found no error.
/// \param report called after every run that came to an answer, or to no verdict; may be empty.
SafetyFactor findSafetyFactor(const Scene& scene, const SafetyTrial& trial,
                              const std::function<void(const SafetyRun&)>& report = {});

}  // namespace keyblock
