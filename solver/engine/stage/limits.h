// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can let go, how near it is, and what happens when it does. Limits are
// judged on an accepted state only; one is released at a time.
#pragma once

#include "solver/engine/model/state.h"

#include <optional>
#include <vector>

namespace keyblock {

enum class LimitKind {
    Bond, CurveEnd, Yield, Hinge, TensileRupture, ShearRupture, Interaction, Plate,  // of bolts
    JointBond, PeakFriction  // of joints
};

struct Limit {
    LimitKind kind = LimitKind::Bond;
    int owner = -1;  // bolt, or contact
    int part = -1;  // node or element
    double ratio = 0.0;  // of what acts to what holds
};

/// True where both are about the same thing, whatever their ratios.
inline bool sameLimit(const Limit& a, const Limit& b) {
    return a.kind == b.kind && a.owner == b.owner && a.part == b.part;
}

/// Every limit that is still held, in the order in which ties are broken:
/// bolts, then nodes and elements, then joints.
std::vector<Limit> heldLimits(const Model& model, const State& state);

/// Shares of a limit within which two overloads are a tie, and to which an event is located.
inline constexpr double tieShare = 1e-6;
inline constexpr double reachedShare = 1e-9;

/// The limit to release: the largest ratio, or the first of those equal to it; none under `least`.
std::optional<Limit> worstLimit(const std::vector<Limit>& limits, double least);

/// True where releasing it changes what holds, so that equilibrium must be found again: not for yield, a hinge, nor for
/// friction or a curve that goes on from the force it has.
bool changesForces(const Model& model, const Limit& limit);

/// Lets it go. \return the events this is, with forces and slip just before.
std::vector<Event> releaseLimit(const Model& model, State& state, const Limit& limit);

}  // namespace keyblock
