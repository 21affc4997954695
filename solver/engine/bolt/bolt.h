// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt as a carrier of force: its shank, anchored points and plate together,
// and what happens to the whole of it when one of them fails.
#pragma once

#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Links of a bolt per node, at most: four of its element, two to the rock, and room for the plate's.
inline constexpr std::size_t linksANode = 7;

/// Links of one bolt: shank, anchored points, plate; none where it is lost or absent.
void addBoltLinks(const Model& model, const State& state, int bolt, StepProblem& problem);

/// Elastic energy held by one bolt: shank, anchored points and plate [J].
double boltEnergy(const Model& model, const State& state, int bolt);

/// An event of a node or an element as the bolt is now.
Event boltEvent(const Model& model, const State& state, const Limit& limit, EventKind kind);

/// Links, history, limits and energy of the bolts.
extern const Carrier boltCarrier;

}  // namespace keyblock
