// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a run between two steps, as one plain value: the run's loop works on
// it and keeps nothing else that its next step depends on. From a copy the run can
// continue, also in another process, and gives the same bytes.
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

/// How much the sink was given so far.
struct Written {
    long events = 0, historyRows = 0, frames = 0;
};

/// When the last frame was kept, and when the next is due.
struct FrameClock {
    double next = 0.0;  // time within the stage
    long keptStep = -1;
    int keptStage = -1;
};

/// Every member is a plain value or a container of such: they are written and read without being listed again.
struct Checkpoint {
    State state;
    int stage = 0;
    bool begun = false;  // the stage
    double time = 0.0;  // within the stage: [s], or pseudo-time 0 … 1
    int increment = 0;  // of a static stage
    IncrementProgress within;  // that increment
    DynamicPace pace;  // of a dynamic stage
    LoadMemory loads;
    Reference reference;
    WatchMemory watch;
    StageStart start;  // of the stage
    EnergyMark energy;  // of the stage
    Health health;  // of the stage
    long firstStep = 0;  // when the stage began
    long passes = 0;  // when the last checkpoint was kept; less than 0 where that was before the stage
    std::size_t resultsKept = 0;  // stages that had ended then
    FrameClock frames;
    EventFrames eventFrames;
    Written written;
    std::vector<BoltExtremes> extremes;  // of the bolts, over the run so far
    std::vector<BlockExtremes> blockExtremes;  // likewise
    std::vector<StageResult> results;  // of the stages that ended
};

}  // namespace keyblock
