// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of an anchored point: what ties a node of the bolt to the rock, along
// its slot and across it. It is bonded, slides, sticks again or is lost; as the
// node passes into another block it leaves its bond behind.
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

#include <optional>

namespace keyblock {

/// The force–slip curve in the current stage: the dynamic one where there is one; null without a curve.
const Backbone* curveNow(const AnchorModel& anchor, const BoltMotion& motion);

/// Friction that an anchored point can carry under the normal force it had, for one metre or one node [N/m or N].
double slidingLimit(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// Force along the slot at which a bonded anchored point debonds [N]; none for a law without one.
std::optional<double> bondStrength(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// Links of a node in the rock: across the slot, then along it.
void addAnchorLinks(BoltStep& step, int node);

/// True for those links.
bool ofAnchor(LinkKind kind);

/// As `Carrier::accept` and `Carrier::relock`, for them.
void acceptAnchor(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);
void relockAnchor(const State& state, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// True for the limits of an anchored point.
bool ofAnchor(LimitKind kind);

/// Limits of an anchored point that still hold.
void addAnchorLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int node, std::vector<Limit>& limits);

/// False where releasing its limit leaves the force as it is: friction or a curve carries on from it.
bool anchorChangesForces(const AnchorModel& anchor, const Limit& limit);

/// The point slides with what is left of its strength, or loses it all.
void releaseAnchor(const AnchorModel& anchor, const Limit& limit, BoltMotion& motion);

/// Nothing is left of it, as the whole bolt is lost.
void loseAnchor(BoltNode& node);

/// True where the point slid before and sticks now, in the same slot.
bool sticksAgain(const BoltNode& before, const BoltNode& after);

/// The nearest node along the bolt that was in a block before.
struct AnchorNeighbour {
    const AnchorModel& anchor;
    const NodeBond& bond;
};

/// A node that comes into a block has no bond there. It rubs with the force of its neighbour, from which it takes over
/// its length, so that the force on the whole length does not depend on where the nodes are.
/// \param neighbour null: none
void enterRock(const AnchorModel& anchor, const AnchorNeighbour* neighbour, NodeBond& bond);

/// The bond of a node that leaves its block stays behind in the rock.
void leaveRock(const AnchorModel& anchor, BoltNode& node);

}  // namespace keyblock
