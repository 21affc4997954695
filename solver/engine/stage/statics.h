// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static stages: equilibrium by pseudo-steps, with load increments that end where the
// first limit is reached, so that one part fails at a time.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/stage/equilibrium.h"

namespace keyblock {

/// A limit that has been reached or exceeded, and the event that caused it.
struct PassedLimit {
    Limit limit;
    long cause = -1;  // number of the event; −1: the load
};

/// Automatically chosen increment lengths, in pseudo-time.
struct ChosenLength {
    double next = 1.0;  // next length to try
    // last accepted length; 0: the load starts or turns here, or a part has failed or a block has jumped since
    double last = 0.0;
    bool grows = true;  // lengths may still increase; false once a search failed or took too long
};

/// Displacement over the last load increase, from which that over the next one is estimated.
struct LoadResponse {
    std::vector<double> moved;  // per unknown; empty: unknown
    double length = 0.0;  // of the load increase, in pseudo-time
};

/// Progress within a load increment. Together with the state, it determines what the next call of `moveStatic` does.
struct IncrementProgress {
    double done = 0.0;  // completed fraction of the increment
    double under = 0.0;  // fraction that acts on the state; above `done` if a search ended with moving blocks
    double step = 0.0;  // next fraction to try; 0: not started
    bool releasing = false;  // a limit has been reached and is released before the load continues
    // If the state is not in equilibrium and limits exceeded while blocks move are released next: the centroids of the
    // blocks in the last equilibrium. Otherwise empty.
    std::vector<Point> fallsFrom;
    double least = 0.0;  // smallest ratio at which a limit is released
    long solves = 0;  // pseudo-steps since the last event or accepted increment
    std::vector<PassedLimit> passed;  // limits reached or exceeded at this load
    long lastRelease = -1;  // number of the last event at this load; −1: none yet
    ChosenLength chosen;
    LoadResponse response;
    double fails = 0.0;  // fraction at which a search found no equilibrium; 0: none yet
    double turnedTo = 0.0;  // fraction up to which a block turned too far; 0: none yet
    double turn = 0.0;  // its rotation, over the allowed one

    bool over() const { return done >= 1.0 && !releasing; }
    bool moving() const { return !fallsFrom.empty(); }
};

/// Makes one move along the load path from `a` to `b` and finds equilibrium again. In a move, either the load is
/// increased, at most up to the first limit, or one limit is released. If `settings.chosen` is set, the length of the
/// load increase is chosen automatically. On return, `state` is the last equilibrium found or, if the result is
/// `NoEquilibrium` or `Undecided`, the state with the moving blocks at the positions that they have reached.
StepEnding moveStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                      const StaticSettings& settings, StepObserver& observer, IncrementProgress& progress);

}  // namespace keyblock
