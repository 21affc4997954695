// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/contacts.h"

#include "geometry/grid.h"
#include "solver/engine/contact/bonded_corners.h"
#include "solver/engine/contact/contact_candidates.h"
#include "solver/engine/contact/contact_history.h"
#include "solver/engine/step/parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace keyblock {
namespace {

constexpr std::size_t pairsATask = 64;

using BlockPairs = std::vector<std::pair<int, int>>;

BlockPairs nearPairs(const Model& model, const std::vector<BlockMotion>& blocks, double margin) {
    std::vector<Box> boxes;
    boxes.reserve(blocks.size());
    const double room = 0.5 * margin + model.tolerance;
    for (const BlockMotion& block : blocks) boxes.push_back(grown(boxOf(block.corners), room));
    BlockPairs pairs = BoxGrid(std::move(boxes)).meetingPairs();
    std::erase_if(pairs, [&](const auto& p) {
        const bool still = model.blocks[p.first].fixed && model.blocks[p.second].fixed;
        const bool gone = blocks[p.first].absent || blocks[p.second].absent;
        return still || gone || sameRock(model, p.first, p.second);
    });
    return pairs;
}

std::vector<Contact> candidatesOf(const CandidateSearch& search, int a, int b) {
    std::vector<Contact> found;
    for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)})
        for (int corner : search.model.blocks[first].turns) search.addCorner(first, corner, second, found);
    return found;
}

/// Two corners at one place, each on an edge that ends at the other. Between faces that meet, only how far apart they
/// are along them counts: across, they may stand open or, in a soft joint, lie well inside each other.
bool sameCorners(const CandidateSearch& search, const Contact& x, const Contact& y) {
    if (x.blockA != y.blockB) return false;
    const Point &px = search.blocks[x.blockA].corners[x.corner], &py = search.blocks[y.blockA].corners[y.corner];
    const double near = 2.0 * search.slack(x.blockA, x.blockB);
    if ((px - py).norm() <= near) return true;
    const Edge ofX = edgeOf(search.blocks[x.blockB].corners, x.edge);
    const Edge ofY = edgeOf(search.blocks[y.blockB].corners, y.edge);
    const bool meet = ofX.outward.dot(ofY.outward) < 0.0 && std::abs(cross(ofX.along, ofY.along)) <= angleSlack;
    const bool ends = std::abs(ofX.outward.dot(py - ofX.start)) <= near;
    return meet && ends && std::abs(ofX.along.dot(px - py)) <= near;
}

void dropDoubles(const CandidateSearch& search, std::vector<Contact>& found) {
    std::vector<char> drop(found.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = i + 1; j < found.size(); ++j) {
            if (drop[i] || drop[j] || !sameCorners(search, found[i], found[j])) continue;
            const bool oldI = sameContact(search.before, found[i]), oldJ = sameContact(search.before, found[j]);
            if (oldI && oldJ) continue;  // both carry: each goes its way
            const bool keepI = oldI != oldJ ? oldI : found[i].gap <= found[j].gap + search.model.tolerance;
            drop[keepI ? j : i] = 1;
        }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!drop[i]) found[kept++] = found[i];
    found.resize(kept);
}

template <typename One>
void forEachPair(std::size_t count, const One& one) {
    if (count < 2 * pairsATask) {
        for (std::size_t i = 0; i < count; ++i) one(i);
        return;
    }
    inParallel(count, pairsATask, one);
}

}  // namespace

std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, const ContactSearch& asked) {
    const BlockPairs pairs = nearPairs(model, blocks, asked.margin);
    const Standings standings(model, blocks, before);
    const std::vector<Drift> drift = driftOf(blocks, asked.path);
    const CandidateSearch search{model, blocks, before, drift, standings, asked.margin};
    std::vector<std::vector<Contact>> perPair(pairs.size());
    std::vector<double> lost(pairs.size(), 0.0);
    forEachPair(pairs.size(), [&](std::size_t i) {
        std::vector<Contact>& found = perPair[i];
        found = candidatesOf(search, pairs[i].first, pairs[i].second);
        dropDoubles(search, found);
        for (Contact& contact : found) lost[i] += giveHistory(model, blocks, before, asked.first, contact);
    });
    std::vector<Contact> contacts;
    for (const auto& found : perPair) contacts.insert(contacts.end(), found.begin(), found.end());
    std::sort(contacts.begin(), contacts.end(), comesBefore);
    const double ended = handOver(model, blocks, before, asked.underWay, contacts);
    if (asked.released) *asked.released += std::accumulate(lost.begin(), lost.end(), ended);
    dropHeldCorners(model, contacts);
    return contacts;
}

std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first) {
    return findContacts(model, blocks, before, {margin, first, false, nullptr, nullptr});
}

void meetDilated(const State& state, std::vector<Contact>& contacts) {
    if (state.openings.empty()) return;
    for (Contact& c : contacts) {
        const double opening = openingOf(state.openings, c) - c.dilation;
        if (opening == 0.0) continue;
        c.dilation += opening;
        if (c.gap > c.gapOffset) c.gapOffset = std::min(c.gap, c.gapOffset + opening);
    }
}

bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   double margin, const Eigen::VectorXd& path) {
    const std::vector<Contact> now = findContacts(model, blocks, contacts, {margin, false, false, &path, nullptr});
    const std::vector<Drift> drift = driftOf(blocks, &path);
    const auto entersUnseen = [&](const Contact& c, const std::vector<Contact>& others) {
        if (c.bonded || sameContact(others, c)) return false;
        const Point& corner = blocks[c.blockA].corners[c.corner];
        const auto moved = [&](int block) {
            return Point(drift[block].shift + drift[block].turn * turnLeft(corner - blocks[block].centroid));
        };
        const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
        const Point from = corner - edge.start + moved(c.blockA) - moved(c.blockB);
        return edge.outward.dot(from) < c.gapOffset - model.tolerance;
    };
    return std::none_of(now.begin(), now.end(), [&](const Contact& c) { return entersUnseen(c, contacts); }) &&
           std::none_of(contacts.begin(), contacts.end(), [&](const Contact& c) { return entersUnseen(c, now); });
}

Edge edgeOf(const std::vector<Point>& corners, int index) {
    const Point& a = corners[index];
    const Point chord = corners[(index + 1) % static_cast<int>(corners.size())] - a;
    const double length = chord.norm();
    const Point along = chord / length;
    return {a, along, -turnLeft(along), length};
}

namespace {

int weakerJoint(const Model& model, int x, int y) {
    const auto strength = [&](int i) {
        return std::tuple(i == intactRow(model), model.joints[i].tanPhi, model.joints[i].cohesion);
    };
    return strength(y) < strength(x) ? y : x;
}

/// Edges of the corner's block beside it that lie along the contact's edge and face it; both where none does.
std::array<int, 2> edgesAtCorner(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c,
                                 bool& meets) {
    const std::vector<Point>& corners = blocks[c.blockA].corners;
    const int n = static_cast<int>(corners.size()), before = (c.corner + n - 1) % n;
    const Point along = edgeOf(blocks[c.blockB].corners, c.edge).along;
    const auto lies = [&](int edge) {
        const Point own = edgeOf(corners, edge).along;
        return own.dot(along) < 0.0 && std::abs(cross(own, along)) <= angleSlack;
    };
    const bool first = lies(before), second = lies(c.corner);
    meets = (first || second) && model.blocks[c.blockA].plateOf < 0 && model.blocks[c.blockB].plateOf < 0;
    return {first || !second ? before : c.corner, second || !first ? c.corner : before};
}

}  // namespace

int governingJoint(const Model& model, const std::vector<BlockMotion>& blocks, const Contact& c, bool first) {
    const BlockModel &a = model.blocks[c.blockA], &b = model.blocks[c.blockB];
    if (a.faceJoints.empty() && b.faceJoints.empty()) return weakerJoint(model, a.jointMaterial, b.jointMaterial);
    bool meets = false;
    const std::array<int, 2> edges = edgesAtCorner(model, blocks, c, meets);
    const auto jointOn = [&](const BlockModel& block, int edge) {
        const int joint = jointOfFace(block, edge);
        return joint == intactRow(model) && !(first && meets) ? block.jointMaterial : joint;
    };
    const int own = weakerJoint(model, jointOn(a, edges[0]), jointOn(a, edges[1]));
    return weakerJoint(model, own, jointOn(b, c.edge));
}

int openingBetween(const Model& model, const Contact& c) {
    const std::vector<int> &a = model.blocks[c.blockA].faceOpenings, &b = model.blocks[c.blockB].faceOpenings;
    if (a.empty() || b.empty()) return -1;
    const auto corner = static_cast<std::size_t>(c.corner);
    const int opening = b[static_cast<std::size_t>(c.edge)];
    return a[corner] == opening || a[(corner + a.size() - 1) % a.size()] == opening ? opening : -1;
}

double openingOf(const std::vector<double>& openings, const Contact& c) {
    const double own = c.opening < 0 ? 0.0 : openings[static_cast<std::size_t>(c.opening)];
    return openings[static_cast<std::size_t>(c.joint)] + own;
}

double widestOpening(const State& state) {
    double widest = 0.0;
    if (state.openings.empty()) return widest;
    for (const Contact& c : state.contacts) widest = std::max(widest, c.dilation);
    return widest;
}

double gapOf(const std::vector<BlockMotion>& blocks, const Contact& c) {
    const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
    return edge.outward.dot(blocks[c.blockA].corners[c.corner] - edge.start);
}

double slipOf(const std::vector<BlockMotion>& blocks, const Contact& c) {
    const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
    return edge.along.dot(blocks[c.blockA].corners[c.corner] - edge.start) - c.lockPlace * edge.length;
}

}  // namespace keyblock
