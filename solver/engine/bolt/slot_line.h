// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a borehole slot is now, and where a node of the bolt is by it.
#pragma once

#include "solver/engine/model/state.h"

namespace keyblock {

/// Where a slot is now.
struct SlotLine {
    Point p2{0.0, 0.0}, along{1.0, 0.0}, across{0.0, 1.0};
    double length = 0.0;  // [m]
};
SlotLine slotLine(const State& state, const Slot& slot);

/// Distance of a node from the slot's line, to its left [m].
double offSlot(const SlotLine& line, const BoltNode& node);

/// Node minus rock along the slot since bonding [m].
double alongSlot(const SlotLine& line, const BoltNode& node);

}  // namespace keyblock
