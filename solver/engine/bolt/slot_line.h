// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Current position of a borehole slot, and the position of a bolt node relative to it.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Current line of a slot: start point, unit vectors along and across it, and length.
struct SlotLine {
    Point p2{0.0, 0.0}, along{1.0, 0.0}, across{0.0, 1.0};
    double length = 0.0;  // [m]
};
SlotLine slotLine(const State& state, const Slot& slot);

/// Signed distance of a node from the slot's line, positive to its left [m].
double offSlot(const SlotLine& line, const BoltNode& node);

/// Displacement of a node along the slot relative to the rock since the node was bonded [m].
double alongSlot(const SlotLine& line, const BoltNode& node);

}  // namespace keyblock
