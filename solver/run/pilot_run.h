// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The beginning of a run, made to learn how long the run will take. Its results are
// discarded.
#pragma once

#include "solver/scene/scene.h"

#include <atomic>
#include <optional>
#include <vector>

namespace keyblock {

/// Progress of a stage and its cost so far.
struct PilotStage {
    int stage = 0;  // in the scene with its collapse stages
    double seconds = 0.0;  // CPU time [s]
    double time = 0.0;  // reached: [s], or pseudo-time 0 … 1
    long steps = 0, passes = 0;
    // the same, at the end: of the last 30 % of the CPU time
    double lateSeconds = 0.0, lateTime = 0.0;
    long latePasses = 0;
    bool over = false;
};

struct PilotRun {
    std::vector<PilotStage> stages;  // those that began, in order
    double seconds = 0.0;  // CPU time of all stages [s]
    bool whole = false;  // the run ended by itself
};

/// Runs a scene on one thread for a limited CPU time, which one iteration may exceed.
/// \param scene a scene that needs no cut. \param most CPU time [s].
/// \return nothing if `stop` became true.
/// \pre `checkScene` found no error in the scene.
std::optional<PilotRun> pilotRun(const Scene& scene, double most, const std::atomic<bool>* stop);

}  // namespace keyblock
