// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contacts.h"

#include "geometry/grid.h"
#include "geometry/polygon.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace keyblock {
namespace {

constexpr double slackShare = 1e-5;  // of the smaller block: how far past an edge's end a corner still stands on it
constexpr double deepest = 0.25;  // of the block's size: deeper is no contact with this edge
constexpr double angleSlack = 0.0523;  // sine of 3°
constexpr std::size_t pairsATask = 64;

auto keyOf(const Contact& c) { return std::tuple(c.blockA, c.corner, c.blockB, c.edge); }
auto sortKey(const Contact& c) {
    return std::tuple(std::min(c.blockA, c.blockB), std::max(c.blockA, c.blockB), c.blockA, c.corner, c.edge);
}

/// The neighbours of a corner that stands before an edge lie on the outer side of the edge.
/// Where an edge of the corner is glued to the next cell, the face goes straight on there.
bool facesEdge(const std::vector<Point>& corners, const std::vector<char>& inner, int corner, const Edge& edge) {
    const int n = static_cast<int>(corners.size()), before = (corner + n - 1) % n;
    const Point& p = corners[corner];
    Point back = corners[before] - p, on = corners[(corner + 1) % n] - p;
    if (!inner.empty() && inner[before] && inner[corner]) return false;
    if (!inner.empty() && inner[before]) back = -on;
    else if (!inner.empty() && inner[corner]) on = -back;
    for (const Point& away : {back, on})
        if (edge.outward.dot(away) < -angleSlack * away.norm()) return false;
    return true;
}

/// The two edges lie on each other's outer side: sides of a notch.
bool faceEachOther(const std::vector<Point>& corners, int e, int f) {
    const Edge first = edgeOf(corners, e), second = edgeOf(corners, f);
    const auto before = [](const Edge& edge, const Edge& other) {
        return edge.outward.dot(other.start + 0.5 * other.length * other.along - edge.start) > 0.0;
    };
    return before(first, second) && before(second, first);
}

struct PairSearch {
    const Model& model;
    const std::vector<BlockMotion>& blocks;
    double margin;

    double slack(int a, int b) const {
        return slackShare * std::min(model.blocks[a].size, model.blocks[b].size) + model.tolerance;
    }

    /// The edges of B that corner `corner` of A stands before, near enough to enter by.
    std::vector<Contact> facedEdges(int a, int corner, int b) const {
        const std::vector<Point>& own = blocks[a].corners;
        const std::vector<Point>& other = blocks[b].corners;
        const double over = slack(a, b);
        std::vector<Contact> faced;
        const std::vector<char>& inner = model.blocks[b].inner;
        for (int e = 0; e < static_cast<int>(other.size()); ++e) {
            if (!inner.empty() && inner[static_cast<std::size_t>(e)]) continue;  // no face: glued to the next cell
            const Edge edge = edgeOf(other, e);
            const Point from = own[corner] - edge.start;
            const double gap = edge.outward.dot(from), along = edge.along.dot(from);
            if (gap > margin || gap < -deepest * model.blocks[b].size) continue;
            if (along < -over || along > edge.length + over) continue;
            if (!facesEdge(own, model.blocks[a].inner, corner, edge)) continue;
            // A top corner of a brick on a wide slab faces the slab's bottom edge too, from above the slab.
            if (gap < -over && locate(other, own[corner], over) == Side::Outside) continue;
            Contact& contact = faced.emplace_back();
            contact.blockA = a, contact.corner = corner, contact.blockB = b, contact.edge = e;
            contact.gap = gap;
            contact.lockPlace = along / edge.length;
        }
        return faced;
    }

    /// Where B bulges, a corner enters by the edge it is least behind; both sides of a notch can hold it.
    void addCorner(int a, int corner, int b, std::vector<Contact>& found) const {
        const std::vector<Contact> faced = facedEdges(a, corner, b);
        for (std::size_t i = 0; i < faced.size(); ++i) {
            bool enters = true;
            for (std::size_t j = 0; j < faced.size() && enters; ++j) {
                const bool nearer = faced[j].gap > faced[i].gap || (faced[j].gap == faced[i].gap && j < i);
                enters = !nearer || faceEachOther(blocks[b].corners, faced[i].edge, faced[j].edge);
            }
            if (enters) found.push_back(faced[i]);
        }
    }

    std::vector<Contact> both(int a, int b) const {
        std::vector<Contact> found;
        for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)})
            for (int c = 0; c < static_cast<int>(blocks[first].corners.size()); ++c) addCorner(first, c, second, found);
        return found;
    }

    const Point& cornerOf(const Contact& c) const { return blocks[c.blockA].corners[c.corner]; }

    /// Two corners at one place, each on an edge that ends at the other.
    bool sameCorners(const Contact& x, const Contact& y) const {
        return x.blockA == y.blockB && (cornerOf(x) - cornerOf(y)).norm() <= 2.0 * slack(x.blockA, x.blockB);
    }
};

/// Length of joint that the corner stands for: half of what its own edges share with the edge.
double jointLength(const std::vector<Point>& own, int corner, const Edge& edge) {
    const int n = static_cast<int>(own.size());
    double length = 0.0;
    for (int neighbour : {(corner + n - 1) % n, (corner + 1) % n}) {
        const Point away = own[neighbour] - own[corner];
        if (std::abs(edge.outward.dot(away)) > angleSlack * away.norm()) continue;
        const double s0 = edge.along.dot(own[corner] - edge.start), s1 = edge.along.dot(own[neighbour] - edge.start);
        length += 0.5 * std::max(0.0, std::min(std::max(s0, s1), edge.length) - std::max(std::min(s0, s1), 0.0));
    }
    return length;
}

const Contact* historyOf(const std::vector<Contact>& before, const Contact& contact) {
    const auto found = std::lower_bound(before.begin(), before.end(), contact,
                                        [](const Contact& x, const Contact& y) { return sortKey(x) < sortKey(y); });
    return found != before.end() && keyOf(*found) == keyOf(contact) ? &*found : nullptr;
}

void dropDoubles(const PairSearch& search, const std::vector<Contact>& before, std::vector<Contact>& found) {
    std::vector<char> drop(found.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = i + 1; j < found.size(); ++j) {
            if (drop[i] || drop[j] || !search.sameCorners(found[i], found[j])) continue;
            const bool oldI = historyOf(before, found[i]) != nullptr, oldJ = historyOf(before, found[j]) != nullptr;
            const bool keepI = oldI != oldJ ? oldI : found[i].gap <= found[j].gap + search.model.tolerance;
            drop[keepI ? j : i] = 1;
        }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!drop[i]) found[kept++] = found[i];
    found.resize(kept);
}

void giveHistory(const PairSearch& search, const std::vector<Contact>& before, bool first, Contact& contact) {
    if (const Contact* old = historyOf(before, contact)) {
        contact = *old;
        return;
    }
    contact.joint = governingJoint(search.model, contact.blockA, contact.blockB);
    const Edge edge = edgeOf(search.blocks[contact.blockB].corners, contact.edge);
    contact.length = jointLength(search.blocks[contact.blockA].corners, contact.corner, edge);
    if (!first || std::abs(contact.gap) > 10.0 * search.model.tolerance) return;
    contact.gapOffset = contact.gap;
    const JointModel& joint = search.model.joints[contact.joint];
    const auto isPlate = [&](int block) { return search.model.blocks[block].plateOf >= 0; };
    const bool plate = isPlate(contact.blockA) || isPlate(contact.blockB);
    contact.bonded = !plate && contact.length > 0.0 && (joint.cohesion > 0.0 || joint.tensileStrength > 0.0);
}

}  // namespace

Edge edgeOf(const std::vector<Point>& corners, int index) {
    const Point& a = corners[index];
    const Point chord = corners[(index + 1) % static_cast<int>(corners.size())] - a;
    const double length = chord.norm();
    const Point along = chord / length;
    return {a, along, -turnLeft(along), length};
}

int governingJoint(const Model& model, int a, int b) {
    const int x = model.blocks[a].jointMaterial, y = model.blocks[b].jointMaterial;
    const auto weaker = [&](int i) { return std::pair(model.joints[i].tanPhi, model.joints[i].cohesion); };
    return weaker(y) < weaker(x) ? y : x;
}

double contactStiffness(const Model& model, int a, int b) {
    return model.analysis.penaltyRatio * model.thickness *
           std::min(model.blocks[a].youngsModulus, model.blocks[b].youngsModulus);
}

std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first) {
    std::vector<Box> boxes;
    boxes.reserve(blocks.size());
    for (const BlockMotion& block : blocks) boxes.push_back(grown(boxOf(block.corners), 0.5 * margin + model.tolerance));
    std::vector<std::pair<int, int>> pairs = BoxGrid(std::move(boxes)).meetingPairs();
    std::erase_if(pairs, [&](const auto& p) {
        const bool still = model.blocks[p.first].fixed && model.blocks[p.second].fixed;
        return still || sameRock(model, p.first, p.second);
    });

    const PairSearch search{model, blocks, margin};
    std::vector<std::vector<Contact>> perPair(pairs.size());
    const auto one = [&](std::size_t i) {
        std::vector<Contact>& found = perPair[i];
        found = search.both(pairs[i].first, pairs[i].second);
        dropDoubles(search, before, found);
        for (Contact& contact : found) giveHistory(search, before, first, contact);
    };
    if (pairs.size() < 2 * pairsATask) {
        for (std::size_t i = 0; i < pairs.size(); ++i) one(i);
    } else {
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pairs.size(), pairsATask), [&](const auto& range) {
            for (std::size_t i = range.begin(); i < range.end(); ++i) one(i);
        });
    }
    std::vector<Contact> contacts;
    for (const auto& found : perPair) contacts.insert(contacts.end(), found.begin(), found.end());
    std::sort(contacts.begin(), contacts.end(),
              [](const Contact& x, const Contact& y) { return sortKey(x) < sortKey(y); });
    return contacts;
}

}  // namespace keyblock
