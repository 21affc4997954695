// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for equilibrium under fixed loads, by pseudo-steps.
//
// A pseudo-step solves the step's minimisation from rest, with 2M/Δt² as a
// regularisation; bodies move, geometry is taken afresh, and equilibrium is
// judged on the true forces there, without that term. Laws are judged from the
// state in which the increment began and accepted at equilibrium, so the path of the
// pseudo-steps leaves no trace, except where a block moves far: its way is accepted
// in pieces.
#pragma once

#include "solver/engine/stage/engine.h"
#include "solver/scene/automatic.h"

namespace keyblock {

struct StaticSettings {
    double unbalanced = 1e-4;  // over the reference force
    double body = automaticBody;  // of its weight, unbalanced on a block
    double smallest = 0.0;  // [m²] blocks under it do not decide
    long maxSteps = automaticIterations;  // pseudo-steps since the last event or accepted increment
    bool chosen = false;  // lengths of increments follow what happens in them
    bool followsFalls = true;  // what falls is followed over its own size, else only as far as shows that it does
};

/// Loads before the search, at which the state is in equilibrium, and those under which it looks for one.
struct LoadPath {
    const LoadPoint& before;
    const LoadPoint& at;
};

/// Moves the state to equilibrium. Without one, or without a verdict, it is left where the moving blocks had got to.
StepEnding findEquilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path,
                           const StaticSettings& settings);

/// The longest way that a prescribed motion may go in one search [m].
double longestMoveOf(const Model& model);

}  // namespace keyblock
