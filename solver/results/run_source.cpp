// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The twin in memory of a run store.
#include "solver/results/run_source.h"

#include "solver/scene/solved_blocks.h"

namespace keyblock {

MemoryRun::MemoryRun(const Scene& scene, const Results& results) : scene_(scene), results_(results), names_(keyblock::blockNames(scene)) {
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
