// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of the face plate: two springs between the bolt's head and the rock, or
// the plate that is a block. While a jack tensions the bolt the plate's force is the
// pretension whatever moves; once the rock has come to rest the nut locks off and
// the plate is a spring that carries it (theory, "Pre-tension").
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

namespace keyblock {

/// Links of the plate: along the bolt, then across it.
void addPlateLinks(BoltStep& step);

/// True for those links.
bool ofPlate(LinkKind kind);

/// As `Carrier::accept`, for them.
void acceptPlate(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// The plate's limit, where it holds.
void addPlateLimit(const BoltModel& bolt, const BoltMotion& motion, int owner, std::vector<Limit>& limits);

/// The plate holds nothing from now on.
void losePlate(BoltMotion& motion);

/// Gives the plate's springs no force where the head is; a plate on excavated rock is lost.
void fitPlate(const BoltModel& bolt, const State& state, BoltMotion& motion);

/// Locks off every plate that is being tensioned, with the force it has. \pre the state is an accepted equilibrium.
void lockOffPlates(const Model& model, State& state);

}  // namespace keyblock
