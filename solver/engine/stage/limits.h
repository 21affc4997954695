// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can fail, how near it is to failing, and its release. Limits are judged on
// an accepted state only; one is released at a time.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/state.h"

#include <optional>
#include <vector>

namespace keyblock {

/// Every limit that still holds, in the order in which ties are broken:
/// bolts, then nodes and elements, then joints.
std::vector<Limit> heldLimits(const Model& model, const State& state);

/// The limit to release: the largest ratio, or the first of those equal to it; none under `least`.
std::optional<Limit> worstLimit(const std::vector<Limit>& limits, double least);

/// True where releasing it changes forces, so that equilibrium must be found again: not for yield, a hinge, nor for
/// friction or a curve that carries on from the force it has.
bool changesForces(const Model& model, const Limit& limit);

/// Releases it. \return the events this is, with forces and slip just before.
std::vector<Event> releaseLimit(const Model& model, State& state, const Limit& limit);

}  // namespace keyblock
