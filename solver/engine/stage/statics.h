// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static stages: equilibrium by pseudo-steps, and increments of load that are
// cut where the first limit is reached, so that one thing fails at a time.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/stage/equilibrium.h"

namespace keyblock {

/// A limit that is passed, and the event whose release brought it there; −1: the load did.
struct PassedLimit {
    Limit limit;
    long cause = -1;
};

/// How much load is put on at once where the program chooses; lengths in pseudo-time.
struct ChosenLength {
    double next = 1.0;  // is tried next
    double last = 0.0;  // was taken last; 0: the load begins or turns here, or something has failed since
    bool grows = true;  // until a search found no equilibrium or took too long
};

/// How far an increment of load is; with the state it is all that the next move depends on.
struct IncrementProgress {
    double done = 0.0;  // share of the increment
    double under = 0.0;  // share that acts on the state: more than `done` where a search ended among moving blocks
    double step = 0.0;  // share that is tried next; 0: not begun
    bool releasing = false;  // something at its limit is released before the load continues
    bool moving = false;  // the state is no equilibrium: blocks move, and bolts that passed their limits on the way let go
    double least = 0.0;  // of a limit, to be released
    long solves = 0;  // pseudo-steps since the last event or accepted increment
    std::vector<PassedLimit> passed;  // at this load
    long lastRelease = -1;  // number of the last event at this load; −1: none yet
    ChosenLength chosen;
    double fails = 0.0;  // share at which a search found no equilibrium; 0: none yet

    bool over() const { return done >= 1.0 && !releasing; }
};

/// One move along the load path from `a` to `b`: the load continues, as far as the first limit at most, and where
/// `settings.chosen` as far as what happens on the way allows; or one thing fails; equilibrium is found after either. On
/// any ending the state is the last equilibrium found, or, for `NoEquilibrium` and `Undecided`, where the moving blocks
/// had got to.
StepEnding moveStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                      const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress);

}  // namespace keyblock
