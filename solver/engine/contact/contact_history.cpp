// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/contact_history.h"

#include "solver/engine/contact/candidates.h"
#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/springs.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace keyblock {
namespace {

constexpr double touching = 10.0;  // times the geometric tolerance
constexpr double leastLength = 1e-3;  // of the smaller block's size: minimum length on which a joint's stiffness acts
constexpr double nearShare = 1e-4;  // of the block's size: this near the end of its edge, a contact may have slid off
constexpr double sameWay = 0.7;  // minimum cosine between the normals of a contact and the one that replaces it

/// The length that the faces at a corner share with an edge.
struct SharedFace {
    bool meets = false;  // a face of the corner lies along the edge
    double length = 0.0;  // of joint tributary to the corner: half the shared length [m]
};

SharedFace sharedFace(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const std::vector<int>& own = model.blocks[c.blockA].turns;
    const std::vector<int>& other = model.blocks[c.blockB].turns;
    const std::vector<Point>& corners = blocks[c.blockA].corners;
    const auto at = [](const std::vector<int>& turns, int corner) {
        return static_cast<int>(std::lower_bound(turns.begin(), turns.end(), corner) - turns.begin());
    };
    const Edge edge = runOf(model.blocks[c.blockB], blocks[c.blockB].corners, at(other, c.edge));
    const int n = static_cast<int>(own.size()), here = at(own, c.corner);
    SharedFace shared;
    for (int neighbour : {own[(here + n - 1) % n], own[(here + 1) % n]}) {
        const Point away = corners[neighbour] - corners[c.corner];
        if (std::abs(edge.outward.dot(away)) > angleSlack * away.norm()) continue;
        const double s0 = edge.along.dot(corners[c.corner] - edge.start);
        const double s1 = edge.along.dot(corners[neighbour] - edge.start);
        shared.meets = true;
        shared.length += 0.5 * std::max(0.0, std::min(std::max(s0, s1), edge.length) - std::max(std::min(s0, s1), 0.0));
    }
    return shared;
}

bool hasStiffness(const JointModel& joint) { return joint.normalStiffness || joint.shearStiffness; }

/// True if the joint has its own stiffness and faces meet. The force then follows from gap and length alone, and both
/// are continuous when one contact replaces another.
bool givesItself(const Model& model, const Contact& c) {
    return model.joints[c.joint].normalStiffness && c.length > 0.0;
}

/// Length on which the joint's stiffness acts; 0 if no faces meet, since there is then no joint that could deform.
double stiffLength(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const SharedFace shared = sharedFace(model, blocks, c);
    const double least = leastLength * std::min(model.blocks[c.blockA].size, model.blocks[c.blockB].size);
    return shared.meets ? std::max(shared.length, least) : 0.0;
}

/// Updates the length on which the joint's stiffness acts to the length on which faces meet. When faces begin or cease
/// to meet, the force is kept. \return the elastic energy that is lost [J].
double followLength(const Model& model, const std::vector<BlockMotion>& blocks, Contact& c) {
    if (c.bonded || !hasStiffness(model.joints[c.joint])) return 0.0;
    const double before = contactEnergy(model, blocks, c);
    const double length = stiffLength(model, blocks, c);
    const bool changes = (length > 0.0) != (c.length > 0.0);
    c.length = length;
    if (changes && c.normalForce > 0.0) {
        carryNormal(model, c, gapOf(blocks, c), c.normalForce);
        carryShear(model, c, slipOf(blocks, c), c.shearForce);
    }
    return before - contactEnergy(model, blocks, c);
}

ContactForces accepted(const Contact& c) { return {c.normalForce, c.shearForce}; }

/// Distance by which the contact's corner has slid past the end of its edge; negative while it is on the edge [m].
double pastEnd(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const std::vector<int>& turns = model.blocks[c.blockB].turns;
    const auto turn = std::lower_bound(turns.begin(), turns.end(), c.edge) - turns.begin();
    const Edge edge = runOf(model.blocks[c.blockB], blocks[c.blockB].corners, static_cast<int>(turn));
    const double along = edge.along.dot(blocks[c.blockA].corners[c.corner] - edge.start);
    return std::max(-along, along - edge.length);
}

/// Direction in which a contact pushes one of its blocks.
Point pushOn(const std::vector<BlockMotion>& blocks, const Contact& c, int block) {
    const Point outward = edgeOf(blocks[c.blockB].corners, c.edge).outward;
    return block == c.blockA ? outward : Point(-outward);
}

/// A block that both contacts push in the same direction; −1 if there is none.
int sharedBlock(const std::vector<BlockMotion>& blocks, const Contact& x, const Contact& y) {
    for (int block : {x.blockA, x.blockB}) {
        const bool ofBoth = block == y.blockA || block == y.blockB;
        if (ofBoth && pushOn(blocks, x, block).dot(pushOn(blocks, y, block)) > sameWay) return block;
    }
    return -1;
}

/// The contacts of each block, as indices into a list of contacts.
class ContactsOfBlocks {
public:
    ContactsOfBlocks(std::size_t blocks, const std::vector<Contact>& contacts)
        : first_(blocks + 1, 0), contacts_(2 * contacts.size()) {
        for (const Contact& c : contacts) ++first_[c.blockA + 1], ++first_[c.blockB + 1];
        std::partial_sum(first_.begin(), first_.end(), first_.begin());
        std::vector<std::ptrdiff_t> next = first_;
        for (int i = 0; const Contact& c : contacts) {
            contacts_[next[c.blockA]++] = contacts_[next[c.blockB]++] = i;
            ++i;
        }
    }

    /// Contacts of either block in ascending order, each once.
    std::vector<int> ofEither(int a, int b) const {
        std::vector<int> either;
        std::set_union(begin(a), begin(a + 1), begin(b), begin(b + 1), std::back_inserter(either));
        return either;
    }

private:
    std::vector<int>::const_iterator begin(int block) const { return contacts_.begin() + first_[block]; }

    std::vector<std::ptrdiff_t> first_;  // per block: its first entry in `contacts_`; then the number of entries
    std::vector<int> contacts_;
};

/// The contact that replaces one that slid off its edge. It lies at the same position on the same side of a block; a
/// contact of the same corner is preferred, then the nearest one. Null if there is none.
Contact* heirOf(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& gone,
                const ContactsOfBlocks& ofBlocks, std::vector<Contact>& found) {
    const double past = pastEnd(model, blocks, gone);
    const double near = nearShare * std::min(model.blocks[gone.blockA].size, model.blocks[gone.blockB].size);
    if (past < -near) return nullptr;  // it opened
    const double reach = 2.0 * std::max(past, 0.0) + near;
    const Point& place = blocks[gone.blockA].corners[gone.corner];
    Contact* heir = nullptr;
    auto best = std::pair(true, std::numeric_limits<double>::max());
    for (const int i : ofBlocks.ofEither(gone.blockA, gone.blockB)) {
        Contact& c = found[i];
        if (sharedBlock(blocks, gone, c) < 0) continue;
        const bool samePair = std::minmax(gone.blockA, gone.blockB) == std::minmax(c.blockA, c.blockB);
        if (givesItself(model, gone) && !samePair) continue;
        const double open = samePair ? std::max(0.0, gone.gapOffset) : 0.0;  // may be as open as the old contact
        const double away = (blocks[c.blockA].corners[c.corner] - place).norm();
        if (away > reach || gapOf(blocks, c) > open + touching * model.tolerance) continue;
        const auto rank = std::pair(c.blockA != gone.blockA || c.corner != gone.corner, away);
        if (rank < best) best = rank, heir = &c;
    }
    return heir;
}

/// Moves the gap at which an open contact begins to carry to its present gap.
void close(const Model& model, const std::vector<BlockMotion>& blocks, Contact& c) {
    const double open = gapOf(blocks, c) - zeroPoints(c, contactSprings(model, c)).first;
    if (open > 0.0) c.gapOffset += open;
}

/// Transfers the forces of `gone` to `heir`: the forces `now`, at the present positions of the blocks, are added to
/// those that it carries, and the accepted forces to its accepted forces.
void inherit(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& gone, const ContactForces& now,
             Contact& heir) {
    const int shared = sharedBlock(blocks, gone, heir);
    const Edge from = edgeOf(blocks[gone.blockB].corners, gone.edge);
    const Edge to = edgeOf(blocks[heir.blockB].corners, heir.edge);
    // the force on A is N·outward − T·along; the force on B is the opposite
    const double sign = (shared == gone.blockA ? 1.0 : -1.0) * (shared == heir.blockA ? 1.0 : -1.0);
    const auto turnedOver = [&](const ContactForces& forces) -> ContactForces {
        const Point force = sign * (forces.normal * from.outward - forces.shear * from.along);
        return {givesItself(model, heir) ? 0.0 : std::max(0.0, force.dot(to.outward)), -force.dot(to.along)};
    };
    if (!givesItself(model, heir)) close(model, blocks, heir);
    addForces(model, heir, turnedOver(now));
    const ContactForces more = turnedOver(accepted(gone));
    heir.normalForce += more.normal;
    heir.shearForce += more.shear;
    heir.limit += gone.limit;
    if (std::abs(gone.slip) > std::abs(heir.slip)) heir.slip = gone.slip;
    heir.slipped = heir.slipped || (gone.slipped && heir.joint == gone.joint);
}

}  // namespace

double lengthOfJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& contact) {
    return sharedFace(model, blocks, contact).length;
}

Contact newContact(const Model& model, const std::vector<BlockMotion>& blocks, bool first, const Candidate& candidate) {
    Contact contact;
    contact.blockA = candidate.blockA, contact.corner = candidate.corner;
    contact.blockB = candidate.blockB, contact.edge = candidate.edge;
    contact.gap = candidate.gap;
    contact.lockPlace = candidate.place;
    contact.position = blocks[contact.blockA].corners[contact.corner];
    const bool touches = std::abs(contact.gap) <= touching * model.tolerance;
    contact.joint = governingJoint(model, blocks, contact, first && touches);
    contact.opening = openingBetween(model, contact);
    const JointModel& joint = model.joints[contact.joint];
    contact.length = hasStiffness(joint) ? stiffLength(model, blocks, contact)
                                         : sharedFace(model, blocks, contact).length;
    if (first && touches) {
        contact.gapOffset = contact.gap;
        const auto isPlate = [&](int block) { return model.blocks[block].plateOf >= 0; };
        const bool holds = joint.cohesion > 0.0 || joint.tensileStrength > 0.0;
        contact.bonded = holds && !isPlate(contact.blockA) && !isPlate(contact.blockB) &&
                         sharedFace(model, blocks, contact).length > model.tolerance;
    } else if (!first && contact.gap < 0.0 && !givesItself(model, contact)) {
        // found with an overlap: it starts without force, otherwise it would add energy
        contact.gapOffset = contact.gap;
    }
    return contact;
}

Contact contactOf(const Model& model, const std::vector<BlockMotion>& blocks, std::span<const Contact> before,
                  bool first, const Candidate& candidate, double& released) {
    if (const Contact* old = sameContact(before, candidate)) {
        Contact contact = *old;
        released += followLength(model, blocks, contact);
        return contact;
    }
    return newContact(model, blocks, first, candidate);
}

double handOver(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& before,
                bool underWay, std::vector<Contact>& found) {
    double lost = 0.0;
    std::vector<Contact> kept;
    std::vector<const Contact*> heirs;
    std::optional<ContactsOfBlocks> ofBlocks;  // where a contact needs an heir
    auto next = found.begin();
    for (const Contact& old : before) {
        if (old.normalForce <= 0.0 && !old.bonded && !underWay) continue;
        while (next != found.end() && comesBefore(*next, old)) ++next;
        if (next != found.end() && !comesBefore(old, *next)) continue;
        if (old.bonded) {
            kept.push_back(old);
            continue;
        }
        const ContactForces now = underWay ? forcesNow(model, blocks, old) : accepted(old);
        if (now.normal <= 0.0 && old.normalForce <= 0.0) continue;
        if (!ofBlocks) ofBlocks.emplace(blocks.size(), found);
        Contact* heir = heirOf(model, blocks, old, *ofBlocks, found);
        const bool known =
            heir && (sameContact(before, *heir) || std::find(heirs.begin(), heirs.end(), heir) != heirs.end());
        // closed and opened again on the way to an equilibrium: its neighbour carries the force from now on
        if (known && underWay && old.normalForce <= 0.0) continue;
        lost += contactEnergy(model, blocks, old);
        if (!heir) continue;
        if (known) lost += contactEnergy(model, blocks, *heir);  // the energy of a new contact was not accounted for
        else heirs.push_back(heir);
        inherit(model, blocks, old, now, *heir);
        lost -= contactEnergy(model, blocks, *heir);
    }
    if (kept.empty()) return lost;
    found.insert(found.end(), kept.begin(), kept.end());
    std::sort(found.begin(), found.end(), comesBefore);
    return lost;
}

}  // namespace keyblock
