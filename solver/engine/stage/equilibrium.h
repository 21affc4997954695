// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search for equilibrium under fixed loads, by pseudo-steps.
//
// A pseudo-step solves the step's minimisation problem from rest, with 2M/Δt² as a
// regularisation. The bodies are moved, the geometry is updated, and equilibrium is
// checked with the true forces there, without that term. Laws are evaluated from the
// state at the start of the increment and accepted at equilibrium, so that the result
// does not depend on the path of the pseudo-steps. The exception is a block that moves
// far: its path is accepted in pieces.
#pragma once

#include "solver/engine/stage/engine.h"
#include "solver/scene/automatic.h"

namespace keyblock {

struct StaticSettings {
    double unbalanced = 1e-4;  // tolerance of the unbalanced force, over the reference force
    double body = automaticBody;  // tolerance of the unbalanced force on a block, over its weight
    double smallest = 0.0;  // smaller blocks do not decide whether there is an equilibrium [m²]
    long maxSteps = automaticIterations;  // maximum number of pseudo-steps since the last event or accepted increment
    bool chosen = false;  // increment lengths are chosen automatically
    // where the blocks were before they began to fall; null: none has been seen to fall
    const std::vector<Point>* fallsFrom = nullptr;
    bool motionFollows = false;  // reduce the unbalanced forces further, so that blocks start at rest
    bool followsFalls = true;  // follow falling blocks until they have moved by their size, not only until they fall
};

/// Loads before a search for equilibrium, with which the state is in equilibrium, and loads for which equilibrium is
/// sought.
struct LoadPath {
    const LoadPoint& before;
    const LoadPoint& at;
};

/// Moves the state to equilibrium under the loads `path.at`. If there is no equilibrium, or if the search cannot decide
/// whether there is one, the blocks are left at the positions that they have reached.
/// \param moved an estimate of the displacement over the search, per unknown, or empty; receives the displacement found.
///        Null: unknown and not needed.
StepEnding findEquilibrium(Engine& engine, State& state, const Loads& loads, const LoadPath& path,
                           const StaticSettings& settings, Eigen::VectorXd* moved = nullptr);

/// Largest prescribed displacement allowed in one search for equilibrium [m].
double longestMoveOf(const Model& model);

}  // namespace keyblock
