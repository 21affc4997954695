// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The in-memory counterpart of a run store, and queries on any run.
#include "solver/results/run_source.h"

#include "solver/scene/collapse_stage.h"
#include "solver/scene/scene_cut.h"
#include "solver/scene/solved_blocks.h"

namespace keyblock {

FrameHead headOf(const Frame& frame) { return {frame.stage, frame.time, frame.step, frame.energy, frame.events}; }

bool endedUnstable(Outcome outcome) { return outcome == Outcome::Collapse || outcome == Outcome::Displaced; }

bool endedAsPlanned(Outcome outcome) { return outcome == Outcome::Equilibrium || outcome == Outcome::Duration; }

namespace {

/// Index of the next stage, or of the one after it if the next stage requires a collapse that did not happen.
std::size_t stageBehind(const Scene& scene, const StageResult& result) {
    const std::size_t next = static_cast<std::size_t>(result.stage) + 1;
    const bool skips = next < scene.stages.size() && scene.stages[next].followsCollapse;
    return skips && result.outcome != Outcome::Collapse ? next + 1 : next;
}

bool goesOn(const Scene& scene, const StageResult& result) {
    const Stage& stage = scene.stages[result.stage];
    const std::size_t next = stageBehind(scene, result);
    if (next < scene.stages.size() && scene.stages[next].followsCollapse) return true;
    if (endedUnstable(result.outcome) || (stage.followsCollapse && endedAsPlanned(result.outcome)))
        return stage.continueAfterCollapse;
    return endedAsPlanned(result.outcome);
}

}  // namespace

std::optional<int> stageAfter(const Scene& scene, const StageResult& result) {
    const std::size_t next = stageBehind(scene, result);
    if (next >= scene.stages.size() || !goesOn(scene, result)) return {};
    return static_cast<int>(next);
}

bool endsRun(const Scene& scene, const StageResult& result) {
    return (endedUnstable(result.outcome) || endedAsPlanned(result.outcome)) && !stageAfter(scene, result);
}

bool isFinished(const RunSource& run) {
    const std::vector<StageRecord> stages = run.stages();
    return !stages.empty() && stages.back().ended && endsRun(run.scene(), stages.back().result);
}

MemoryRun::MemoryRun(const Scene& scene, const Results& results)
    : scene_(withCollapseStages(needsCut(scene) ? cutScene(scene).scene : scene)), results_(results),
      names_(keyblock::blockNames(scene_)) {
    for (const Frame& frame : results.frames)
        heads_.push_back(headOf(frame));
}

std::vector<StageRecord> MemoryRun::stages() const {
    std::vector<StageRecord> records;
    for (const StageResult& result : results_.stages)
        records.push_back({result, true});
    return records;
}

}  // namespace keyblock
