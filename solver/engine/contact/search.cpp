// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/search.h"

#include "geometry/grid.h"
#include "solver/engine/contact/bonded_corners.h"
#include "solver/engine/contact/candidates.h"
#include "solver/engine/contact/history.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/step/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

}  // namespace keyblock
