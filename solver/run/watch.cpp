// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/watch.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace keyblock {
namespace {

using Pair = WatchMemory::Pair;

std::pair<int, int> pairOf(const Model& model, const Contact& c) {
    return std::minmax(wholeOf(model, c.blockA), wholeOf(model, c.blockB));
}

bool isClosed(const Model& model, const Contact& c) {
    return c.bonded || c.normalForce > 0.0 || c.gap - c.gapOffset <= 10.0 * model.tolerance;
}

bool slides(const Model& model, const Contact& c) {
    return !c.bonded && c.normalForce > 0.0 && std::abs(c.slip) > 10.0 * model.tolerance &&
           std::abs(c.shearForce) >= c.limit * (1.0 - 1e-9);
}

ClosedJoint closedJoint(const Pair& blocks, const Contact& c) {
    return {blocks, std::minmax(c.blockA, c.blockB), c.position, c.normalForce, c.shearForce, c.slip};
}

/// Adds the joint to a sorted list if it is not in it. Contacts are sorted, too, but for those of blocks divided into
/// cells.
void addJoint(const Pair& blocks, const Contact& c, std::vector<ClosedJoint>& joints) {
    auto at = joints.end();
    if (!joints.empty() && !(joints.back().blocks < blocks)) {
        at = std::ranges::lower_bound(joints, blocks, {}, &ClosedJoint::blocks);
        if (at->blocks == blocks) return;
    }
    joints.insert(at, closedJoint(blocks, c));
}

Event jointEvent(EventKind kind, const ClosedJoint& joint) {
    Event event;
    event.kind = kind;
    event.block = joint.bodies.first;
    event.otherBlock = joint.bodies.second;
    event.position = joint.position;
    event.axialForce = -joint.normalForce;
    event.shearForce = joint.shearForce;
    event.slip = joint.slip;
    return event;
}

/// Whether an unbroken length of the bolt connects the block to other rock. A piece that fell out together with the
/// block does not support it.
bool ties(const Model& model, const BoltMotion& bolt, int block) {
    bool inside = false, elsewhere = false;
    for (std::size_t n = 0; n < bolt.nodes.size(); ++n) {
        if (n > 0 && bolt.elements[n - 1].ruptured) inside = elsewhere = false;
        if (const int slot = bolt.nodes[n].slot; slot >= 0) {
            const bool own = wholeOf(model, bolt.slots[slot].block) == block;
            (own ? inside : elsewhere) = true;
        }
        if (inside && elsewhere) return true;
    }
    return false;
}

/// Whether a contact or a bolt supports the block or one of its cells.
bool carried(const Model& model, const State& state, int block) {
    for (const Contact& c : state.contacts)
        if ((c.bonded || c.normalForce > 0.0) &&
            (wholeOf(model, c.blockA) == block || wholeOf(model, c.blockB) == block))
            return true;
    return std::any_of(state.bolts.begin(), state.bolts.end(),
                       [&](const BoltMotion& bolt) { return acts(bolt) && ties(model, bolt, block); });
}

}  // namespace

Watch::Watch(const Model& model, const State& start, WatchMemory& memory) : model_(model), memory_(memory) {
    for (const BlockMotion& block : start.blocks) start_.push_back(block.centroid);
    for (const BoltMotion& bolt : start.bolts) {
        std::vector<char> held(bolt.slots.size(), 0);
        for (const BoltNode& node : bolt.nodes)
            if (node.slot >= 0) held[node.slot] = 1;
        memory_.inhabited.push_back(std::move(held));
    }
}

void Watch::beginStage(const State& state) const {
    memory_.slipped.clear();
    memory_.opened.clear();
    memory_.closed.clear();
    for (const Contact& c : state.contacts)
        if (isClosed(model_, c)) addJoint(pairOf(model_, c), c, memory_.closed);
}

void Watch::remember(const Event& event) const {
    if (event.otherBlock < 0) return;
    const Pair pair = std::minmax(wholeOf(model_, event.block), wholeOf(model_, event.otherBlock));
    if (event.kind == EventKind::JointSlip) memory_.slipped.insert(pair);
    if (event.kind == EventKind::JointOpen) memory_.opened.insert(pair);
}

/// Joints between blocks that sleep are as they were and are not looked at.
void Watch::lookAtJoints(const State& state, std::vector<Event>& events) const {
    std::vector<ClosedJoint> now;
    auto known = memory_.slipped.begin();
    const auto isNew = [&](const Pair& pair) {  // contacts are sorted, so `known` mostly moves on by one
        if (known != memory_.slipped.begin() && !(*std::prev(known) < pair)) known = memory_.slipped.lower_bound(pair);
        while (known != memory_.slipped.end() && *known < pair) ++known;
        return known == memory_.slipped.end() || *known != pair;
    };
    for (const Contact& c : state.contacts) {
        if (rest(state, {c.blockA, c.blockB}) || !isClosed(model_, c)) continue;
        const Pair pair = pairOf(model_, c);
        addJoint(pair, c, now);
        if (!slides(model_, c) || !isNew(pair)) continue;
        known = memory_.slipped.insert(known, pair);
        events.push_back(jointEvent(EventKind::JointSlip, closedJoint(pair, c)));
    }
    lookForOpenings(state, now, events);
}

/// Reports the joints that have opened, and brings the list of closed joints up to date.
/// \param now the closed joints between blocks that do not rest, sorted by blocks.
void Watch::lookForOpenings(const State& state, const std::vector<ClosedJoint>& now, std::vector<Event>& events) const {
    std::vector<ClosedJoint> added;
    auto next = now.begin();
    auto kept = memory_.closed.begin();
    for (const ClosedJoint& before : memory_.closed) {
        while (next != now.end() && next->blocks < before.blocks) added.push_back(*next++);
        if (next != now.end() && next->blocks == before.blocks) *kept++ = *next++;
        else if (rest(state, before.blocks)) *kept++ = before;
        else reportOpening(state, before, events);
    }
    memory_.closed.erase(kept, memory_.closed.end());
    added.insert(added.end(), next, now.end());
    const auto middle = memory_.closed.insert(memory_.closed.end(), added.begin(), added.end());
    std::ranges::inplace_merge(memory_.closed, middle, {}, &ClosedJoint::blocks);
}

/// Reports a joint that has opened, once in a stage, with the forces of a contact that is still near or else the last
/// known ones.
void Watch::reportOpening(const State& state, const ClosedJoint& before, std::vector<Event>& events) const {
    if (!memory_.opened.insert(before.blocks).second) return;
    const auto still = std::ranges::find_if(state.contacts,
                                            [&](const Contact& c) { return pairOf(model_, c) == before.blocks; });
    const bool isNear = still != state.contacts.end();
    events.push_back(jointEvent(EventKind::JointOpen, isNear ? closedJoint(before.blocks, *still) : before));
}

/// True if both blocks are fixed or asleep.
bool Watch::rest(const State& state, const Pair& blocks) const {
    const auto rests = [&](int block) { return model_.blocks[block].fixed || state.blocks[block].rest.asleep; };
    return rests(blocks.first) && rests(blocks.second);
}

void Watch::lookForFalls(State& state, std::vector<Event>& events) const {
    for (std::size_t i = 0; i < state.blocks.size(); ++i) {
        BlockMotion& block = state.blocks[i];
        const int whole = wholeOf(model_, static_cast<int>(i));
        if (block.fallen || block.absent || model_.blocks[i].fixed || whole != static_cast<int>(i)) continue;
        if ((block.centroid - start_[i]).norm() < wholeSize(model_, whole) || carried(model_, state, whole)) continue;
        block.fallen = true;
        Event event;
        event.kind = EventKind::BlockFalls;
        event.block = static_cast<int>(i);
        event.position = block.centroid;
        events.push_back(event);
    }
}

void Watch::lookForPulledOut(State& state, std::vector<Event>& events) const {
    for (std::size_t b = 0; b < state.bolts.size(); ++b) {
        BoltMotion& bolt = state.bolts[b];
        if (!acts(bolt)) continue;
        memory_.inhabited[b].resize(bolt.slots.size(), 0);  // adds blocks that the bolt has entered since
        for (const BoltNode& node : bolt.nodes)
            if (node.slot >= 0) memory_.inhabited[b][node.slot] = 1;
        for (std::size_t s = 0; s < bolt.slots.size(); ++s) {
            if (!memory_.inhabited[b][s] || bolt.leftSlot[s]) continue;
            const auto isIn = [&](int slot, std::size_t of) {  // this slot or that of another cell of the block
                const int own = bolt.slots[slot].block;
                const bool sameBlock = model_.blocks[own].cell && sameRock(model_, own, bolt.slots[of].block);
                return slot == static_cast<int>(of) || sameBlock;
            };
            const bool held = std::any_of(bolt.nodes.begin(), bolt.nodes.end(),
                                          [&](const BoltNode& n) { return n.slot >= 0 && isIn(n.slot, s); });
            if (held) continue;
            for (std::size_t other = s; other < bolt.slots.size(); ++other)
                if (isIn(static_cast<int>(other), s)) bolt.leftSlot[other] = 1;
            Event event;
            event.kind = EventKind::PulledOut;
            event.bolt = static_cast<int>(b);
            event.block = bolt.slots[s].block;
            const BlockMotion& rock = state.blocks[event.block];
            event.position = materialPoint(rock, bolt.slots[s].p3);
            events.push_back(event);
        }
    }
}

std::vector<Event> Watch::look(State& state) const {
    std::vector<Event> events;
    lookAtJoints(state, events);
    lookForFalls(state, events);
    lookForPulledOut(state, events);
    return events;
}

}  // namespace keyblock
