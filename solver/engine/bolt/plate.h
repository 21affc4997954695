// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of the face plate: two springs between the bolt head and the rock, or between
// the head and a plate that is modelled as a block. While a jack tensions the bolt, the
// plate force equals the pretension regardless of displacements. Once equilibrium is
// reached the nut is locked off, and the plate becomes a spring that carries that force
// (theory, "Pre-tension").
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Adds the links of the face plate, first the link along the bolt and then the one across it.
void addPlateLinks(BoltStep& step);

/// True if links of this kind belong to face plates.
bool ofPlate(LinkKind kind);

/// Like `Carrier::accept`, for the links of the face plate.
void acceptPlate(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// Adds the limit of the face plate unless the plate has been lost. \param owner index of the bolt.
void addPlateLimit(const BoltModel& bolt, const BoltMotion& motion, int owner, std::vector<Limit>& limits);

/// Marks the face plate as lost; it then no longer carries any force.
void losePlate(BoltMotion& motion);

/// Sets the zero points of the plate's springs to the current position of the head. A plate on excavated rock is lost.
void fitPlate(const BoltModel& bolt, const State& state, BoltMotion& motion);

/// Locks off, at their pretension, all face plates that are being tensioned.
/// \pre the state is an accepted equilibrium.
void lockOffPlates(const Model& model, State& state);

}  // namespace keyblock
