// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/slot_line.h"

namespace keyblock {

SlotLine slotLine(const State& state, const Slot& slot) {
    SlotLine line;
    const BlockMotion& rock = state.blocks[slot.block];
    line.p2 = materialPoint(rock, slot.p2);
    const Point chord = materialPoint(rock, slot.p3) - line.p2;
    line.length = chord.norm();
    line.along = chord / line.length;
    line.across = turnLeft(line.along);
    return line;
}

double offSlot(const SlotLine& line, const BoltNode& node) { return line.across.dot(node.x - line.p2); }

double alongSlot(const SlotLine& line, const BoltNode& node) {
    return line.along.dot(node.x - line.p2) - node.bond.place * line.length;
}

}  // namespace keyblock
