// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/frame_forces.h"

#include "solver/run/observation.h"

#include <utility>

namespace keyblock {
namespace {

/// Sorts forces into the lists of a frame.
class Sorter {
public:
    Sorter(const State& state, const Frame& frame, bool moves) : state_(state), frame_(frame), moves_(moves) {
        int shown = 0;
        for (const Contact& c : state.contacts) contactRows_.push_back(isShown(c) ? shown++ : -1);
        for (std::size_t bolt = 0; bolt < frame.bolts.size(); ++bolt) addNodeRows(bolt);
        forces_.bodies.resize(frame.blocks.size());
        if (moves) forces_.contacts.resize(frame.contacts.size());
    }

    void add(const SingleForce& single) {
        switch (single.force.source) {
            case ForceSource::Weight: body(single).weight = single.force.force; return;
            case ForceSource::Inertia:
                body(single).inertia = single.force.force;
                body(single).inertiaMoment = single.force.moment;
                return;
            case ForceSource::Contact: addContact(single); return;
            case ForceSource::Glue: addBond(single); return;
            case ForceSource::Bolt: addBolt(single); return;
            default: addOther(single); return;
        }
    }

    FrameForces take() { return std::move(forces_); }

private:
    BodyForce& body(const SingleForce& single) { return forces_.bodies[single.force.block]; }

    /// Bolts that are not installed have nodes in the engine but none in a frame.
    void addNodeRows(std::size_t bolt) {
        const int first = static_cast<int>(nodeBlocks_.size());
        for (const BoltNodeFrame& node : frame_.bolts[bolt].nodes) nodeBlocks_.push_back(node.block);
        const bool there = !frame_.bolts[bolt].nodes.empty();
        for (int n = 0; n < static_cast<int>(state_.bolts[bolt].nodes.size()); ++n)
            nodeRows_.push_back(there ? first + n : -1);
        forces_.nodes.resize(nodeBlocks_.size(), Point(0.0, 0.0));
    }

    void addContact(const SingleForce& single) {
        const int row = contactRows_[single.part];
        if (row < 0) return addOther(single);
        if (!moves_) return;
        const bool isA = state_.contacts[single.part].blockA == single.force.block;
        ContactStepForce& step = forces_.contacts[row];
        if (isA) step.force = single.force.force;
        (isA ? step.momentA : step.momentB) = single.force.moment;
    }

    /// The force at one end is enough.
    void addBond(const SingleForce& single) {
        if (single.force.block < single.force.other) addOther(single);
    }

    void addBolt(const SingleForce& single) {
        const int row = single.part < 0 ? -1 : nodeRows_[single.part];
        if (row < 0 || nodeBlocks_[row] != single.force.block) return addOther(single);
        forces_.nodes[row] = single.force.force;
    }

    void addOther(const SingleForce& single) {
        BlockForce force = single.force;
        force.position += frame_.blocks[force.block].centroid;
        forces_.others.push_back(force);
    }

    const State& state_;
    const Frame& frame_;
    bool moves_;
    std::vector<int> contactRows_;  // per contact of the state: row in the frame; −1: not shown
    std::vector<int> nodeRows_;  // per node of the engine: row in the frame; −1: bolt not installed
    std::vector<int> nodeBlocks_;  // block of each node of the frame
    FrameForces forces_;
};

}  // namespace

FrameForces frameForces(const std::vector<SingleForce>& forces, const State& state, const Frame& frame, bool moves) {
    Sorter sorter(state, frame, moves);
    for (const SingleForce& single : forces) sorter.add(single);
    return sorter.take();
}

}  // namespace keyblock
