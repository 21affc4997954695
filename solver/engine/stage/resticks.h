// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Detection of re-sticking anchored points. When sliding stops, no force changes at
// that moment; the point continues as an elastic spring. A re-stick is therefore not a
// limit to be released, but is found by comparing the states before and after.
#pragma once

#include "solver/engine/stage/engine.h"

#include <optional>

namespace keyblock {

/// Copy of the state if any anchored point slides and can re-stick; otherwise none.
std::optional<State> ifSliding(const State& state);

/// Reports every anchored point that slides in `before` and sticks in `after`, in the order of bolts and nodes. The
/// state `before` is reported with each event. Does nothing if `before` is none.
/// \param cause the number of the event that caused the points to stick; −1: the load.
void reportResticks(const Model& model, const std::optional<State>& before, const State& after, double time,
                    long cause, StepObserver& observer);

}  // namespace keyblock
