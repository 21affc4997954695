// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which states are kept as frames in addition to those at equal intervals, so that
// no failure of a bolt falls between two frames: the state just before it, the one
// just after it, and the largest force that a bolt reaches in motion. A run with
// thousands of failures keeps no more of them than it has frames at equal intervals.
#pragma once

#include "solver/engine/model/state.h"
#include "solver/results/results.h"
#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

struct KeptAt {
    int stage = -1;  // −1: none yet
    double time = 0.0;  // within the stage
};

/// What has been kept so far; part of the checkpoint.
struct EventFrames {
    std::vector<double> shown;  // largest axial force of each bolt in any frame so far, without its sign [N]
    long kept = 0;
    KeptAt before, after;  // the last frames just before and just after failures
    bool owed = false;  // bolts have failed, and the state after that is in no frame yet
};

/// True for failures of bolts: each belongs between two frames.
bool callsForFrames(const Event& event);

/// True for events seen in a state that has already been accepted, so that no state lies just before them.
bool isSeenAfterwards(const Event& event);

/// True where a bolt carries a visibly larger axial force than in any frame so far.
bool exceedsShown(const Model& model, const State& state, const EventFrames& frames);

/// True where it is so much larger that it is kept even after as many frames as there may be.
bool isFarAboveShown(const Model& model, const State& state, const EventFrames& frames);

/// True where the step from `before` to `after` passed the largest force so far of a bolt, and no frame shows it.
bool passedPeak(const Model& model, const State& before, const State& after, const EventFrames& frames);

/// Takes a state that has become a frame into account.
void noteShown(const Model& model, const State& state, EventFrames& frames);

/// \param planned frames at equal intervals until the end of the stage
bool mayKeep(const EventFrames& frames, long planned);

/// True where a frame was kept so shortly before a time that one more shows nothing new.
/// \param interval between frames at equal intervals, in the time of the stage
bool isShortlyAfter(const KeptAt& kept, const KeptAt& now, double interval);

}  // namespace keyblock
