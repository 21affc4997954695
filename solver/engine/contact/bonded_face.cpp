// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/bonded_face.h"

#include "solver/engine/contact/candidates.h"
#include "solver/engine/model/edge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace keyblock {
namespace {

constexpr double samePlace = 10.0;  // times the geometric tolerance
constexpr double leastArm = 0.25;  // of a cell's size: the centroid of a sliver may be close to the face

/// The contact at the other end of a joined face. \pre The contact exists, because bonded contacts are never dropped.
const Contact& otherEnd(const std::vector<Contact>& contacts, const Contact& c) {
    Contact key;
    key.blockA = c.face.other[0], key.corner = c.face.other[1];
    key.blockB = c.face.other[2], key.edge = c.face.other[3];
    return *sameContact(contacts, key);
}

Contact& otherEnd(std::vector<Contact>& contacts, const Contact& c) {
    return const_cast<Contact&>(otherEnd(std::as_const(contacts), c));
}

/// Modulus of a bar under axial stress, in plane strain or plane stress according to the elasticity [Pa].
double barModulus(const BlockModel& block) {
    const Eigen::Matrix3d& elasticity = block.elasticity;
    return elasticity(0, 0) - elasticity(0, 1) * elasticity(1, 0) / elasticity(1, 1);
}

/// Displacement of the face at `place` under unit traction due to the deformation of the cell [m/Pa]. It is zero for a
/// whole block, which has its own strains.
double flexibility(const Model& model, const std::vector<BlockMotion>& blocks, int row, const Point& place,
                   const Point& outward) {
    const BlockModel& block = model.blocks[row];
    if (!block.cell) return 0.0;
    const double arm = std::abs(outward.dot(blocks[row].centroid - place));
    return std::max(arm, leastArm * block.size) / barModulus(block);
}

/// Distance of two points from the middle of the face, over half the length of the face, such that two springs with the
/// contact's stiffness resist rotation as the cells and the joint do. It is at most the value for a traction that
/// varies linearly along the face.
double spreadOf(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c) {
    const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
    const Point& corner = blocks[c.blockA].corners[c.corner];
    const JointModel& joint = model.joints[c.joint];
    const double way = flexibility(model, blocks, c.blockA, corner, edge.outward) +
                       flexibility(model, blocks, c.blockB, corner, edge.outward) +
                       (joint.normalStiffness ? 1.0 / *joint.normalStiffness : 0.0);
    const double springs = contactSprings(model, c).normal * way;  // [m²], for comparison with length · thickness
    return std::sqrt(std::min(1.0, c.length * model.thickness / springs) / 3.0);
}

/// The neighbour of the contact's corner along the face towards `far`; −1 if there is none.
int neighbourTowards(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c, const Point& far) {
    const std::vector<int>& turns = model.blocks[c.blockA].turns;
    const std::vector<Point>& corners = blocks[c.blockA].corners;
    const std::size_t n = turns.size();
    const std::size_t here = std::lower_bound(turns.begin(), turns.end(), c.corner) - turns.begin();
    const Point way = far - corners[c.corner];
    for (int neighbour : {turns[(here + n - 1) % n], turns[(here + 1) % n]}) {
        const Point side = corners[neighbour] - corners[c.corner];
        if (side.dot(way) > std::cos(angleSlack) * side.norm() * way.norm()) return neighbour;
    }
    return -1;
}

bool onOneFace(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& x, const Contact& y) {
    const Point way = blocks[y.blockA].corners[y.corner] - blocks[x.blockA].corners[x.corner];
    const double near = samePlace * model.tolerance, distance = way.norm();
    if (std::abs(x.length - y.length) > near || std::abs(distance - 2.0 * x.length) > near || distance <= near) return false;
    return std::abs(edgeOf(blocks[x.blockB].corners, x.edge).outward.dot(way)) <= angleSlack * distance;
}

/// Locks the contact so that it carries these forces at the present positions of the blocks.
void carry(const Model& model, const std::vector<BlockMotion>& blocks, Contact& c, const ContactForces& forces) {
    c.lockPlace = placeOnEdge(blocks, c);
    carryNormal(model, c, gapOf(blocks, c), forces.normal);
    carryShear(model, c, slipOf(blocks, c), forces.shear);
    c.normalForce = forces.normal;
    c.shearForce = forces.shear;
}

double energyOf(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& x, const Contact& y) {
    return contactEnergy(model, blocks, x) + contactEnergy(model, blocks, y);
}

/// Joins the two ends of a bonded face. \return the elastic energy that is lost [J].
double join(const Model& model, const std::vector<BlockMotion>& blocks, Contact& x, Contact& y) {
    const Point atX = blocks[x.blockA].corners[x.corner], atY = blocks[y.blockA].corners[y.corner];
    const int towardY = neighbourTowards(model, blocks, x, atY), towardX = neighbourTowards(model, blocks, y, atX);
    if (towardY < 0 || towardX < 0) return 0.0;
    const double before = energyOf(model, blocks, x, y), spread = spreadOf(model, blocks, x);
    const double inward = 0.5 * (1.0 - spread) * (atY - atX).norm();
    const auto share = [&](const Contact& c, int toward) {
        return inward / (blocks[c.blockA].corners[toward] - blocks[c.blockA].corners[c.corner]).norm();
    };
    x.face = {towardY, share(x, towardY), spread, {y.blockA, y.corner, y.blockB, y.edge}};
    y.face = {towardX, share(y, towardX), spread, {x.blockA, x.corner, x.blockB, x.edge}};
    const double mean = 0.5 * (x.normalForce + y.normalForce);
    const double apart = 0.5 * (x.normalForce - y.normalForce) / spread;
    carry(model, blocks, x, {mean + apart, x.shearForce});
    carry(model, blocks, y, {mean - apart, y.shearForce});
    return before - energyOf(model, blocks, x, y);
}

bool canBeJoined(const Model& model, const Contact& c) {
    return c.bonded && c.face.toward < 0 && (model.blocks[c.blockA].cell || model.blocks[c.blockB].cell);
}

}  // namespace

double joinBondedFaces(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts) {
    if (model.glue.empty()) return 0.0;
    std::map<std::pair<int, int>, std::vector<Contact*>> byPair;
    for (Contact& c : contacts)
        if (canBeJoined(model, c)) byPair[std::minmax(c.blockA, c.blockB)].push_back(&c);
    double lost = 0.0;
    for (auto& [pair, ends] : byPair)
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = i + 1; k < ends.size() && ends[i]->face.toward < 0; ++k)
                if (ends[k]->face.toward < 0 && onOneFace(model, blocks, *ends[i], *ends[k]))
                    lost += join(model, blocks, *ends[i], *ends[k]);
    return lost;
}

double partBondedFace(const Model& model, const std::vector<BlockMotion>& blocks, std::vector<Contact>& contacts,
                      Contact& contact) {
    if (contact.face.toward < 0) return 0.0;
    Contact& other = otherEnd(contacts, contact);
    const double before = energyOf(model, blocks, contact, other);
    const ContactForces here = forcesAtCorner(contacts, contact), there = forcesAtCorner(contacts, other);
    contact.face = other.face = {};
    carry(model, blocks, contact, here);
    carry(model, blocks, other, there);
    return before - energyOf(model, blocks, contact, other);
}

ContactForces forcesAtCorner(const std::vector<Contact>& contacts, const Contact& c) {
    if (c.face.toward < 0) return {c.normalForce, c.shearForce};
    const double other = otherEnd(contacts, c).normalForce;
    return {0.5 * (c.normalForce + other) + 0.5 * c.face.spread * (c.normalForce - other), c.shearForce};
}

double edgeCompression(const std::vector<Contact>& contacts, const Contact& c) {
    if (c.face.toward < 0) return c.normalForce;
    const double other = otherEnd(contacts, c).normalForce;
    return 0.5 * (c.normalForce + other) + 1.5 * c.face.spread * (c.normalForce - other);
}

}  // namespace keyblock
