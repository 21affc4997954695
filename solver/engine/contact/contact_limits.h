// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What can fail of a joint: bonds, and the peak of its friction.
#pragma once

#include "solver/engine/carrier/limit.h"
#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// True for the limits of joints.
inline bool ofJoint(LimitKind kind) { return kind == LimitKind::JointBond || kind == LimitKind::PeakFriction; }

/// Limits of all contacts that still hold, in their order: peak friction, then bond.
void addJointLimits(const Model& model, const State& state, std::vector<Limit>& limits);

/// Releases one of them: the bond is lost, or friction falls to its residual angle. \return its event.
std::vector<Event> releaseJoint(const Model& model, State& state, const Limit& limit);

}  // namespace keyblock
