// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs all stages of a scene; the call returns when the run ends. The command line,
// the tests and the window's worker thread call the same function; a control handle
// stops and pauses the run and reports its progress.
#pragma once

#include "solver/run/sink.h"
#include "solver/scene/scene_cut.h"

#include <atomic>
#include <functional>

namespace keyblock {

/// Progress of a run; reported after every iteration, from the run's thread.
struct Progress {
    int stage = 0;
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    double fraction = 0.0;  // completed fraction of the whole run, 0 … 1
    long steps = 0;  // accepted steps of the run
    long passes = 0;  // iterations of the stage
    long events = 0;
    double residual = 0.0;  // largest relative unbalanced force of the stage
    long stepCuts = 0;  // time-step or increment reductions of the stage, including those for energy errors
    StepHealth step;  // the latest step
};

/// Text that describes a long search for equilibrium, e.g. "searching, 40 solves: b161 moves 12 mm"; empty for a search
/// of fewer than 10 solves.
/// \param names the block names as returned by `blockNames`.
std::string searchText(const StepHealth& step, const std::vector<std::string>& names);

/// Control handle of a run, owned by the caller. The run checks it in every iteration.
struct Control {
    std::atomic<bool> stop{false};
    std::atomic<bool> pause{false};
    std::atomic<int> steps{0};  // number of single steps to take while paused
    std::function<void(const Progress&)> progress;  // may be empty
    std::atomic<bool> look{false};  // requests the state at the end of the step; reset when `looked` is called
    std::function<void(const Frame&)> looked;  // receives the requested state, in the thread of the run; may be empty
};

struct RunSettings {
    int threads = 0;  // 0: one per hardware thread; does not affect the results
    const SceneCut* cut = nullptr;  // the scene after cutting, if already computed
};

/// Runs every stage of a checked scene, or resumes an unfinished run.
/// \param from the checkpoint to resume from, which a run of the same scene and build has passed to its sink; null:
///        start from the beginning.
/// \pre `checkScene(scene)` found no error.
/// \throws UnfitCheckpoint (checkpoint_check.h) if `from` does not fit the scene.
/// \return one result for each stage that began. No stage is run after a stage with the outcome `Failed` (numerical
///         failure), `Undecided`, `Stopped` or `Limit`; for a stage that became unstable, see `stageAfter`.
std::vector<StageResult> run(const Scene& scene, Sink& sink, Control& control, const RunSettings& settings = {},
                             const Checkpoint* from = nullptr);

/// Runs every stage of a checked scene and keeps the results in memory, for tests and verification.
Results runInMemory(const Scene& scene, const RunSettings& settings = {});

}  // namespace keyblock
