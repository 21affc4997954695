// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The twin in memory of a run store, and what any run can be asked.
#include "solver/results/run_source.h"

#include "solver/scene/scene_cut.h"
#include "solver/scene/solved_blocks.h"

namespace keyblock {

bool endedUnstable(Outcome outcome) { return outcome == Outcome::Collapse || outcome == Outcome::Displaced; }

bool endedAsPlanned(Outcome outcome) { return outcome == Outcome::Equilibrium || outcome == Outcome::Duration; }

bool endsRun(const Scene& scene, const StageResult& result) {
    const auto stage = static_cast<std::size_t>(result.stage);
    const bool last = stage + 1 == scene.stages.size();
    if (endedUnstable(result.outcome))
        return last || !scene.stages[stage].continueAfterCollapse;
    return last && endedAsPlanned(result.outcome);
}

bool isFinished(const RunSource& run) {
    const std::vector<StageRecord> stages = run.stages();
    return !stages.empty() && stages.back().ended && endsRun(run.scene(), stages.back().result);
}

MemoryRun::MemoryRun(const Scene& scene, const Results& results)
    : scene_(needsCut(scene) ? cutScene(scene).scene : scene), results_(results),
      names_(keyblock::blockNames(scene_)) {
    for (const Frame& frame : results.frames)
        heads_.push_back({frame.stage, frame.time, frame.step, frame.energy});
}

std::vector<StageRecord> MemoryRun::stages() const {
    std::vector<StageRecord> records;
    for (const StageResult& result : results_.stages)
        records.push_back({result, true});
    return records;
}

}  // namespace keyblock
