// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stages to the end, blocking. The command line, the tests and the window's
// worker call the same function; a control handle stops, pauses and reports.
#pragma once

#include "solver/run/sink.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <functional>

namespace keyblock {

/// How far a run is; sent after every step, from the thread that runs.
struct Progress {
    int stage = 0;
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    double fraction = 0.0;  // of the whole run, 0 … 1
    long steps = 0;
    long passes = 0;
    long events = 0;
    double residual = 0.0;
    long stepCuts = 0;  // of the stage, those for the energy among them
    StepHealth step;  // the newest
};

/// A search for equilibrium that has not ended after some solves, as in "searching, 40 solves: b161 moves 12 mm";
/// empty for a shorter one. \param names of the blocks, as `blockNames` gives them.
std::string searchText(const StepHealth& step, const std::vector<std::string>& names);

/// Handed to a run and kept by its caller. Checked in every iteration.
struct Control {
    std::atomic<bool> stop{false};
    std::atomic<bool> pause{false};
    std::atomic<int> steps{0};  // still to be taken while paused
    std::function<void(const Progress&)> progress;  // may be empty
    std::atomic<bool> look{false};  // the state at the end of the step is requested; taken back once it is handed over
    std::function<void(const Frame&)> looked;  // gets it, from the thread that runs; may be empty
};

struct RunSettings {
    int threads = 0;  // 0: as many as the machine has; never changes a result
    const SceneCut* cut = nullptr;  // what the scene was cut to, where that is known already
};

/// Runs every stage of a checked scene, or resumes a run that was cut short.
/// \param from handed to a sink by a run of the same scene and build; null: from the beginning.
/// \pre `checkScene(scene)` found no error.
/// \return one result per stage begun. A collapse is a result; the outcome `Failed`
///         (numerical failure), `Stopped` or `Limit` ends the run.
std::vector<StageResult> run(const Scene& scene, Sink& sink, Control& control, const RunSettings& settings = {},
                             const Checkpoint* from = nullptr);

/// The same into memory, for tests and verification.
Results runInMemory(const Scene& scene, const RunSettings& settings = {});

}  // namespace keyblock
