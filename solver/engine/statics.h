// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static stages: equilibrium by pseudo-steps, and increments of load that are
// cut where the first limit is reached, so that one thing lets go at a time.
#pragma once

#include "solver/engine/engine.h"

namespace keyblock {

struct StaticSettings {
    double unbalanced = 1e-4;  // over the reference force
    int maxSteps = 400;  // pseudo-steps of one search for equilibrium
};

/// Takes `state` along the load path from `a` to `b`. On any ending the state is the last equilibrium found,
/// or, for `NoEquilibrium`, where the moving blocks had got to.
StepEnding advanceStatic(Engine& engine, State& state, const Loads& loads, const LoadPoint& a, const LoadPoint& b,
                         const StaticSettings& settings, StepObserver& observer, LoadPoint& reached);

}  // namespace keyblock
