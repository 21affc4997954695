// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Limits of joints: bond strength and peak friction.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// True if limits of this kind belong to joints.
inline bool ofJoint(LimitKind kind) { return kind == LimitKind::JointBond || kind == LimitKind::PeakFriction; }

/// Adds the joint limits that have not been released yet, in the order of the contacts; for each contact, peak friction
/// comes before the bond.
void addJointLimits(const Model& model, const State& state, std::vector<Limit>& limits);

/// Releases a joint limit: the bond fails, or friction drops to the residual angle.
/// \return the resulting event.
std::vector<Event> releaseJoint(const Model& model, State& state, const Limit& limit);

}  // namespace keyblock
