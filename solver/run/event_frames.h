// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Selects states to be stored as frames in addition to those at equal intervals, so
// that no bolt failure is missed between two frames: the states just before and just
// after it, and the state with the largest force of a bolt in a dynamic stage. Even a
// run with thousands of failures stores hardly more of these than frames at equal intervals.
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

/// Additional frames stored so far; part of the checkpoint.
struct EventFrames {
    std::vector<double> shown;  // largest magnitude of the axial force of each bolt in any frame so far [N]
    long kept = 0;  // number of additional frames
    KeptAt before, after;  // the last frames just before and just after failures
    bool owed = false;  // bolts have failed since the last frame, so a frame after the failures is due
};

/// True for bolt failures, which need one frame just before the failure and one just after it.
bool callsForFrames(const Event& event);

/// True for events detected only after the step was accepted, for which there is no state just before the event.
bool isSeenAfterwards(const Event& event);

/// True if the axial force of a bolt is noticeably larger (by more than 0.2 %) than in any frame so far.
bool exceedsShown(const Model& model, const State& state, const EventFrames& frames);

/// True if the axial force of a bolt is so much larger (by more than 5 %) than in any frame so far that the state is
/// stored even if `mayKeep` returns false.
bool isFarAboveShown(const Model& model, const State& state, const EventFrames& frames);

/// True if the axial force of a bolt is larger in state `before` than in the next state `after`, and noticeably larger
/// than in any frame so far.
bool passedPeak(const Model& model, const State& before, const State& after, const EventFrames& frames);

/// Updates `frames.shown` with the axial forces in a state that is stored as a frame.
void noteShown(const Model& model, const State& state, EventFrames& frames);

/// True if one more frame may be stored in addition to those at equal intervals.
/// \param planned the number of frames at equal intervals from the start of the run to the end of the current stage.
bool mayKeep(const EventFrames& frames, long planned);

/// True if `now` is so soon after the stored frame at `kept` that another frame would show nothing new.
/// \param interval the time between the regular frames of the stage: [s], or pseudo-time in a static stage.
bool isShortlyAfter(const KeptAt& kept, const KeptAt& now, double interval);

}  // namespace keyblock
