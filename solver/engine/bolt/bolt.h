// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt as a force carrier: its shank, anchored points and face plate, and the loss of
// the whole bolt when one of them fails.
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Maximum number of links per bolt node: four for its element, two to the rock, and an allowance for the face plate.
inline constexpr std::size_t linksANode = 7;

/// Adds the links of one bolt: shank, anchored points and face plate. Adds nothing if the bolt is lost or absent.
void addBoltLinks(const Model& model, const State& state, int bolt, StepProblem& problem,
                  RockGradients rockGradients = RockGradients::Given);

/// Elastic energy of one bolt [J]: shank, anchored points and face plate.
double boltEnergy(const Model& model, const State& state, int bolt);

/// Event of kind `kind` for the node or element of `limit`, with its current position, forces and slip.
Event boltEvent(const Model& model, const State& state, const Limit& limit, EventKind kind);

/// Force carrier of the bolts.
extern const Carrier boltCarrier;

}  // namespace keyblock
