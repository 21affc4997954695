// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The law of an anchored point: the connection of a bolt node to the rock along and
// across its borehole slot. The point is bonded, slides, re-sticks or has failed. A node
// that passes into another block loses its bond.
#pragma once

#include "solver/engine/bolt/bolt_step.h"
#include "solver/engine/carrier/carrier.h"

#include <optional>

namespace keyblock {

/// Force–slip curve for the current stage, with dynamic strength where applicable; null if the law has no curve.
const Backbone* curveNow(const AnchorModel& anchor, const BoltMotion& motion);

/// Sliding resistance of an anchored point under its last accepted normal force [N/m or N]; per metre or per node, as
/// in the anchor's law.
/// \param strengthFactor ratio of dynamic to static bond strength.
double slidingLimit(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// Force along the slot at which a bonded anchored point debonds [N]; none if the law has no bond strength.
/// \param strengthFactor ratio of dynamic to static bond strength.
std::optional<double> bondStrength(const AnchorModel& anchor, const BoltNode& node, double strengthFactor);

/// Adds the links of a node that is in rock, first the link across the slot and then the one along it.
void addAnchorLinks(BoltStep& step, int node);

/// True if links of this kind belong to anchored points.
bool ofAnchor(LinkKind kind);

/// Like `Carrier::accept` and `Carrier::relock`, for the links of anchored points.
void acceptAnchor(BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);
void relockAnchor(const State& state, BoltMotion& motion, EnergyLedger& energy, const SolvedLink& solved);

/// True if limits of this kind belong to anchored points.
bool ofAnchor(LimitKind kind);

/// Adds the limits of an anchored point that have not been released yet. \param owner index of the bolt.
void addAnchorLimits(const BoltModel& bolt, const BoltMotion& motion, int owner, int node, std::vector<Limit>& limits);

/// True if releasing the limit changes the force. False if friction or the force–slip curve continues from the same
/// force.
bool anchorChangesForces(const AnchorModel& anchor, const Limit& limit);

/// Releases a limit: the point slides with its residual strength, or fails completely.
void releaseAnchor(const AnchorModel& anchor, const Limit& limit, BoltMotion& motion);

/// Marks an anchored point as failed because the whole bolt is lost.
void loseAnchor(BoltNode& node);

/// True if the point was sliding before and now sticks in the same slot.
bool sticksAgain(const BoltNode& before, const BoltNode& after);

/// For a node that enters a block: the nearest node along the bolt that was already in this block.
struct AnchorNeighbour {
    const AnchorModel& anchor;
    const NodeBond& bond;
};

/// Initialises the bond of a node that enters a block. The node is not bonded there; it carries the same frictional
/// force per metre as its neighbour and takes over part of the neighbour's tributary length. The total force on the
/// embedded length therefore does not depend on the positions of the nodes.
/// \param neighbour the neighbouring node; null if there is none.
void enterRock(const AnchorModel& anchor, const AnchorNeighbour* neighbour, NodeBond& bond);

/// Removes the bond of a node that leaves its block.
void leaveRock(const AnchorModel& anchor, BoltNode& node);

}  // namespace keyblock
