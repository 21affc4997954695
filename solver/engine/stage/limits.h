// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Strength limits: the list of parts that can fail, their load-to-strength ratios, and
// their release. Limits are evaluated in accepted states only, and one is released at a
// time.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/state.h"

#include <optional>
#include <vector>

namespace keyblock {

/// All limits that have not been released yet, in the order in which ties are broken: bolts with their nodes and
/// elements, then joints.
std::vector<Limit> heldLimits(const Model& model, const State& state);

/// Limit to release next: the one with the largest ratio of load to strength, or the first of several with the same
/// ratio. None if all ratios are below `least`.
std::optional<Limit> worstLimit(const std::vector<Limit>& limits, double least);

/// True if releasing the limit changes forces, so that equilibrium must be found again. Forces do not change when
/// steel yields or a plastic hinge forms, or when friction or a force–slip curve continues from the current force.
bool changesForces(const Model& model, const Limit& limit);

/// Lets the part that has reached the limit fail. \return the resulting events, with forces and slip just before the
/// failure.
std::vector<Event> releaseLimit(const Model& model, State& state, const Limit& limit);

}  // namespace keyblock
