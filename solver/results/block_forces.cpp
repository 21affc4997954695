// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/block_forces.h"

#include "solver/results/frame_quantities.h"

#include <algorithm>
#include <tuple>

namespace keyblock {
namespace {

class Lister {
public:
    explicit Lister(const Frame& frame) : frame_(frame) {}

    std::vector<BlockForce> list() {
        addBodies();
        addContacts();
        addNodes();
        for (const BlockForce& force : frame_.forces.others) addOther(force);
        std::stable_sort(rows_.begin(), rows_.end(), [](const BlockForce& a, const BlockForce& b) {
            return std::tie(a.block, a.source) < std::tie(b.block, b.source);
        });
        return std::move(rows_);
    }

private:
    const Point& centroid(int block) const { return frame_.blocks[block].centroid; }

    void add(const BlockForce& row) {
        if (row.block < 0 || frame_.blocks[row.block].area == 0.0) return;
        if (row.force.isZero(0.0) && row.moment == 0.0) return;
        rows_.push_back(row);
    }

    void addAt(int block, ForceSource source, int other, const Point& at, const Point& force) {
        if (block >= 0) add({block, source, other, at, force, momentAbout(centroid(block), at, force)});
    }

    void addBodies() {
        for (int block = 0; block < static_cast<int>(frame_.forces.bodies.size()); ++block) {
            const BodyForce& body = frame_.forces.bodies[block];
            add({block, ForceSource::Weight, -1, centroid(block), body.weight, 0.0});
            add({block, ForceSource::Inertia, -1, centroid(block), body.inertia, body.inertiaMoment});
        }
    }

    void addContacts() {
        const bool moves = !frame_.forces.contacts.empty();
        for (std::size_t i = 0; i < frame_.contacts.size(); ++i) {
            const ContactFrame& c = frame_.contacts[i];
            if (moves) addStep(c, frame_.forces.contacts[i]);
            else addPair(c);
        }
    }

    void addPair(const ContactFrame& c) {
        const Point force = forceOnA(c);
        addAt(c.blockA, ForceSource::Contact, c.blockB, c.position, force);
        addAt(c.blockB, ForceSource::Contact, c.blockA, c.position, -force);
    }

    void addStep(const ContactFrame& c, const ContactStepForce& step) {
        add({c.blockA, ForceSource::Contact, c.blockB, c.position, step.force, step.momentA});
        add({c.blockB, ForceSource::Contact, c.blockA, c.position, -step.force, step.momentB});
    }

    void addNodes() {
        std::size_t row = 0;
        for (std::size_t bolt = 0; bolt < frame_.bolts.size(); ++bolt)
            for (const BoltNodeFrame& node : frame_.bolts[bolt].nodes)
                if (row < frame_.forces.nodes.size())
                    addAt(node.block, ForceSource::Bolt, static_cast<int>(bolt), node.position, frame_.forces.nodes[row++]);
    }

    /// A bond exerts equal and opposite forces on its two cells at the same point, and opposite couples.
    void addOther(const BlockForce& force) {
        add(force);
        if (force.source != ForceSource::Glue) return;
        BlockForce opposite = force;
        std::swap(opposite.block, opposite.other);
        opposite.force = -force.force;
        const double couple = force.moment - momentAbout(centroid(force.block), force.position, force.force);
        opposite.moment = momentAbout(centroid(opposite.block), force.position, opposite.force) - couple;
        add(opposite);
    }

    const Frame& frame_;
    std::vector<BlockForce> rows_;
};

}  // namespace

std::vector<BlockForce> blockForces(const Frame& frame) {
    if (frame.forces.bodies.empty()) return {};
    return Lister(frame).list();
}

double momentAbout(const Point& centre, const Point& at, const Point& force) { return cross(at - centre, force); }

}  // namespace keyblock
