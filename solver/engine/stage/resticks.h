// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Friction that stops sliding changes no force at that moment: the point carries
// on as an elastic spring. So a re-stick is no limit that is released, but is found by
// comparing the states before and after.
#pragma once

#include "solver/engine/stage/engine.h"

#include <optional>

namespace keyblock {

/// A copy of the state where some anchored point slides and may stick; nothing where none does.
std::optional<State> ifSliding(const State& state);

/// Reports, in the order of bolts and nodes, every anchored point that slid in `before` and sticks in `after`, each
/// with the state before. \param cause the event that relieved them; −1: the load did.
void reportResticks(const Model& model, const std::optional<State>& before, const State& after, double time,
                    long cause, StepObserver& observer);

}  // namespace keyblock
