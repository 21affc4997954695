// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a run between two steps as one plain value. The run's loop works on it
// and keeps nothing else on which its next step depends. A run resumed from a copy,
// even in another process, gives results that are identical byte for byte.
#pragma once

#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/statics.h"
#include "solver/run/energy_limit.h"
#include "solver/run/event_frames.h"
#include "solver/run/observation.h"
#include "solver/run/stability.h"
#include "solver/run/stage_loads.h"
#include "solver/run/watch.h"

#include <vector>

namespace keyblock {

/// Number of items written to the sink so far.
struct Written {
    long events = 0, historyRows = 0, frames = 0;
};

/// The last of the frames that are stored at equal intervals, and the time of the next one.
struct FrameClock {
    double next = 0.0;  // time within the stage at which the next frame is due
    long keptStep = -1;
    int keptStage = -1;
};

/// Complete state of a run. Every member is a plain value or a container of plain values, so that all members can be
/// written and read without listing them by name.
struct Checkpoint {
    State state;
    int stage = 0;
    bool begun = false;  // whether the stage has begun
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    int increment = 0;  // index of the increment, in a static stage
    IncrementProgress within;  // progress within that increment
    DynamicPace pace;  // in a dynamic stage
    LoadMemory loads;
    Reference reference;
    WatchMemory watch;
    StageStart start;
    EnergyMark energy;
    Health health;  // diagnostics of the stage
    long firstStep = 0;  // number of accepted steps at the start of the stage
    long passes = 0;  // iterations of the stage at the last checkpoint; negative if that was before the stage
    std::size_t resultsKept = 0;  // number of stages that had ended at the last checkpoint
    FrameClock frames;
    EventFrames eventFrames;
    Written written;
    std::vector<BoltExtremes> extremes;  // one per bolt, over the run so far
    std::vector<BlockExtremes> blockExtremes;  // one per block, over the run so far
    std::vector<StageResult> results;  // one per stage that has ended
};

}  // namespace keyblock
