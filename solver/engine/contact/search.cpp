// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/search.h"

#include "solver/engine/contact/bonded_corners.h"
#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/contact_history.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/step/parallel.h"
#include "solver/engine/step/phase.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keyblock {
namespace {

constexpr std::size_t pairsOfBatch = 64;

/// Pairs of blocks between which contacts are searched for.
struct SearchedPairs {
    BlockPairs pairs;
    std::vector<NeighbourList::Pair> listed;  // the same in the neighbour list; empty without one
};

SearchedPairs nearPairs(const Model& model, const std::vector<BlockMotion>& blocks,
                        const std::vector<Outline>& outlines, const NeighbourList* list, double margin) {
    const auto isSearched = [&](int a, int b) {
        const bool still = model.blocks[a].fixed && model.blocks[b].fixed;
        return !still && !blocks[a].absent && !blocks[b].absent;
    };
    SearchedPairs found;
    if (!list) {
        found.pairs = pairsWithin(model, outlines, margin);
        std::erase_if(found.pairs, [&](const auto& p) { return !isSearched(p.first, p.second); });
        return found;
    }
    for (const NeighbourList::Pair& pair : list->pairs()) {
        if (!isSearched(pair.a, pair.b) || !areWithin(model, outlines[pair.a], outlines[pair.b], margin)) continue;
        found.pairs.emplace_back(pair.a, pair.b);
        found.listed.push_back(pair);
    }
    return found;
}

/// Collects the candidates of two blocks in `found`, and the corners near edges in `corners`.
class PairCandidates {
public:
    PairCandidates(const CandidateSearch& search, int a, int b, std::vector<Candidate>& found,
                   FoundCorners::Batch& corners)
        : search_(search), found_(found), corners_(corners), pair_{a, b, std::ssize(corners.corners)} {}

    /// Adds a corner of block `a` whose near edges of block `b` are found by `addNear`.
    void add(int a, int corner, int b, const auto& addNear) {
        const std::ptrdiff_t begin = std::ssize(corners_.near);
        addNear(corners_.near);
        const std::span near(corners_.near.begin() + begin, corners_.near.end());
        if (near.empty()) return;
        pair_.allowedChange = std::min(pair_.allowedChange, search_.addEntrances(a, corner, b, near, found_));
        corners_.corners.push_back({a, corner, b, begin, std::ssize(corners_.near)});
    }

    void finish() {
        pair_.end = std::ssize(corners_.corners);
        corners_.pairs.push_back(pair_);
    }

private:
    const CandidateSearch& search_;
    std::vector<Candidate>& found_;
    FoundCorners::Batch& corners_;
    FoundCorners::Pair pair_;
};

/// Adds the candidates of two blocks to `found`, and the corners near edges to `corners`.
void findCandidates(const CandidateSearch& search, int a, int b, std::vector<Candidate>& found,
                    FoundCorners::Batch& corners) {
    PairCandidates candidates(search, a, b, found, corners);
    for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
        const Box reach = search.reachOf(first, second);
        for (int corner : search.model.blocks[first].turns) {
            const Point& place = search.blocks[first].corners[corner];
            if (!meets(reach, {place, place})) continue;
            candidates.add(first, corner, second, [&, own = first, other = second](std::vector<NearEdge>& near) {
                search.addNearEdges(own, corner, other, near);
            });
        }
    }
    candidates.finish();
}

/// The same from the neighbour list.
void findCandidates(const CandidateSearch& search, const NeighbourList& list, const NeighbourList::Pair& pair,
                    std::vector<Candidate>& found, FoundCorners::Batch& corners) {
    PairCandidates candidates(search, pair.a, pair.b, found, corners);
    for (const NeighbourList::Corner& c : list.corners(pair))
        candidates.add(c.block, c.corner, c.other, [&](std::vector<NearEdge>& near) {
            search.addNearEdges(c.block, c.corner, c.other, list.turns(c), near);
        });
    candidates.finish();
}

std::span<const FoundCorners::Corner> cornersOf(const FoundCorners::Batch& batch, const FoundCorners::Pair& pair) {
    return {batch.corners.begin() + pair.begin, batch.corners.begin() + pair.end};
}

/// For each block, the largest displacement on `drift` of its corners, and of other blocks' corners near its edges as
/// far as they move with it [m].
std::vector<double> largestMoves(const Model& model, const std::vector<Outline>& outlines, double margin,
                                 const std::vector<Drift>& drift) {
    std::vector<double> moves(drift.size());
    for (std::size_t i = 0; i < drift.size(); ++i) {
        const double reach = outlines[i].across + model.blocks[i].size + 2.0 * margin;
        moves[i] = drift[i].shift.norm() + std::abs(drift[i].turn) * reach;
    }
    return moves;
}

/// Compares a path with that of a search.
class OtherPath {
public:
    OtherPath(const Model& model, const FoundCorners& found, const std::vector<Drift>& drift)
        : margin_(found.margin), moves_(largestMoves(model, found.outlines, found.margin, drift)) {
        std::vector<Drift> change = drift;
        for (std::size_t i = 0; i < change.size(); ++i) {
            change[i].shift -= found.drift[i].shift;
            change[i].turn -= found.drift[i].turn;
        }
        changes_ = largestMoves(model, found.outlines, found.margin, change);
    }

    /// True if one of the blocks moves by so much that corners may come near edges that the search did not consider.
    bool isFar(const FoundCorners::Pair& pair) const {
        return 2.0 * std::max(moves_[pair.a], moves_[pair.b]) > margin_;
    }

    /// True if the contacts of the pair may be others.
    bool mayDiffer(const FoundCorners::Pair& pair) const {
        return isFar(pair) || changes_[pair.a] + changes_[pair.b] >= pair.allowedChange;
    }

private:
    double margin_;
    std::vector<double> moves_, changes_;  // per block, on the path and against that of the search [m]
};

/// Finds the candidates of a pair in a batch again for another path. \param isFar true if all their corners have to be
/// searched, not only those that were found.
std::vector<Candidate> candidatesAgain(const CandidateSearch& search, const FoundCorners::Batch& batch,
                                       const FoundCorners::Pair& pair, bool isFar) {
    std::vector<Candidate> found;
    FoundCorners::Batch corners;
    if (isFar) findCandidates(search, pair.a, pair.b, found, corners);
    else
        for (const FoundCorners::Corner& c : cornersOf(batch, pair))
            search.addEntrances(c.a, c.corner, c.b, {batch.near.begin() + c.begin, batch.near.begin() + c.end}, found);
    return found;
}

/// True if two corners are at the same position, each on an edge that ends at the other. Between faces that meet, only
/// their distance along the faces counts; normal to the faces they may be apart or, in a soft joint, overlap deeply.
bool sameCorners(const CandidateSearch& search, const Candidate& x, const Candidate& y) {
    if (x.blockA != y.blockB) return false;
    const Point &px = search.blocks[x.blockA].corners[x.corner], &py = search.blocks[y.blockA].corners[y.corner];
    const double near = 2.0 * search.slack(x.blockA, x.blockB);
    if ((px - py).norm() <= near) return true;
    const Edge ofX = edgeOf(search.blocks[x.blockB].corners, x.edge);
    const bool ends = std::abs(ofX.outward.dot(py - ofX.start)) <= near;
    if (!ends || std::abs(ofX.along.dot(px - py)) > near) return false;
    const Edge ofY = edgeOf(search.blocks[y.blockB].corners, y.edge);
    return ofX.outward.dot(ofY.outward) < 0.0 && std::abs(cross(ofX.along, ofY.along)) <= angleSlack;
}

void dropDoubles(const CandidateSearch& search, std::vector<Candidate>& found) {
    boost::container::small_vector<char, 16> drop(found.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (std::size_t j = i + 1; j < found.size(); ++j) {
            if (drop[i] || drop[j] || !sameCorners(search, found[i], found[j])) continue;
            const bool oldI = sameContact(search.before, found[i]), oldJ = sameContact(search.before, found[j]);
            if (oldI && oldJ) continue;  // both existed before: keep both
            const bool keepI = oldI != oldJ ? oldI : found[i].gap <= found[j].gap + search.model.tolerance;
            drop[keepI ? j : i] = 1;
        }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (!drop[i]) found[kept++] = found[i];
    found.resize(kept);
}

std::vector<Contact> joined(const std::vector<std::vector<Contact>>& parts) {
    std::vector<Contact> contacts;
    contacts.reserve(std::accumulate(parts.begin(), parts.end(), std::size_t{0},
                                     [](std::size_t sum, const auto& found) { return sum + found.size(); }));
    for (const auto& found : parts) contacts.insert(contacts.end(), found.begin(), found.end());
    if (!std::is_sorted(contacts.begin(), contacts.end(), comesBefore))
        std::sort(contacts.begin(), contacts.end(), comesBefore);
    return contacts;
}

/// Whether a search for another path would find the contacts between two blocks again.
bool findsTheSame(const CandidateSearch& search, const FoundCorners::Batch& batch, const FoundCorners::Pair& pair,
                  bool isFar) {
    std::vector<Candidate> found = candidatesAgain(search, batch, pair, isFar);
    dropDoubles(search, found);
    const auto placeOf = [](const auto& contact) { return ContactPlace(contact); };
    std::ranges::sort(found, {}, placeOf);
    return std::ranges::equal(found, search.before, {}, placeOf, placeOf);
}

/// Adds the contacts between two blocks that a search for another path would find. Those in `search.before` are copied.
void addContactsOn(const CandidateSearch& search, const FoundCorners::Batch& batch, const FoundCorners::Pair& pair,
                   bool isFar, std::vector<Contact>& contacts) {
    std::vector<Candidate> found = candidatesAgain(search, batch, pair, isFar);
    dropDoubles(search, found);
    for (const Candidate& candidate : found) {
        const Contact* old = sameContact(search.before, candidate);
        contacts.push_back(old ? *old : newContact(search.model, search.blocks, false, candidate));
    }
}

/// Compares the contacts through which corners enter blocks on a path.
struct Entrances {
    const Model& model;
    const std::vector<BlockMotion>& blocks;
    const std::vector<Drift>& drift;
    double deep;  // of the smaller block's size: corners that enter no deeper are disregarded

    /// Whether a contact closes on the path.
    bool closes(const Contact& c) const {
        const Point& corner = blocks[c.blockA].corners[c.corner];
        const auto moved = [&](int block) {
            return Point(drift[block].shift + drift[block].turn * turnLeft(corner - blocks[block].centroid));
        };
        const Edge edge = edgeOf(blocks[c.blockB].corners, c.edge);
        const Point from = corner - edge.start + moved(c.blockA) - moved(c.blockB);
        const double size = std::min(model.blocks[c.blockA].size, model.blocks[c.blockB].size);
        return edge.outward.dot(from) < c.gapOffset - std::max(model.tolerance, deep * size);
    }

    /// Whether every contact of a sorted list that closes on the path is also in the other list.
    bool allIn(const std::vector<Contact>& contacts, const std::vector<Contact>& others) const {
        auto next = others.begin();
        return std::none_of(contacts.begin(), contacts.end(), [&](const Contact& c) {
            while (next != others.end() && comesBefore(*next, c)) ++next;
            const bool known = next != others.end() && !comesBefore(c, *next);
            return !known && !c.bonded && closes(c);
        });
    }

    /// Whether both lists have the same contacts among those that close on the path.
    bool same(const std::vector<Contact>& contacts, const std::vector<Contact>& now) const {
        return allIn(now, contacts) && allIn(contacts, now);
    }
};

/// The neighbour list, if it may be used for this search; otherwise null.
const NeighbourList* readyList(const Model& model, const std::vector<BlockMotion>& blocks,
                               const std::vector<Outline>& outlines, const std::vector<Drift>& drift,
                               const ContactSearch& asked) {
    if (!asked.neighbours) return nullptr;
    const std::vector<double> moves = largestMoves(model, outlines, asked.margin, drift);
    const double farthest = moves.empty() ? 0.0 : 2.0 * *std::ranges::max_element(moves);
    return asked.neighbours->prepare(model, blocks, outlines, asked.margin, farthest) ? asked.neighbours : nullptr;
}

}  // namespace

std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, const ContactSearch& asked) {
    const PhaseScope phase(Phase::Search);
    std::vector<Outline> outlines = outlinesOf(model, blocks);
    std::vector<Drift> drift = driftOf(blocks, asked.path);
    const NeighbourList* list = readyList(model, blocks, outlines, drift, asked);
    const auto searched = nearPairs(model, blocks, outlines, list, asked.margin);
    const BlockPairs& pairs = searched.pairs;
    Standings standings(model, blocks, before);
    const std::size_t batches = (pairs.size() + pairsOfBatch - 1) / pairsOfBatch;
    std::vector<std::vector<Contact>> perBatch(batches);
    std::vector<double> lost(pairs.size(), 0.0);
    std::vector<FoundCorners::Batch> corners(batches);
    const std::vector<std::span<const Contact>> beforeOf = contactsOfPairs(before, pairs);
    forEach(batches, 1, [&](std::size_t batch) {
        std::vector<Candidate> found;
        const std::size_t end = std::min(pairs.size(), (batch + 1) * pairsOfBatch);
        for (std::size_t i = batch * pairsOfBatch; i < end; ++i) {
            const std::span<const Contact>& own = beforeOf[i];
            const CandidateSearch search{model, blocks, own, drift, outlines, standings, asked.margin, asked.estimated};
            found.clear();
            if (list) findCandidates(search, *list, searched.listed[i], found, corners[batch]);
            else findCandidates(search, pairs[i].first, pairs[i].second, found, corners[batch]);
            dropDoubles(search, found);
            for (const Candidate& one : found)
                perBatch[batch].push_back(contactOf(model, blocks, own, asked.first, one, lost[i]));
        }
    });
    if (asked.corners)
        *asked.corners = {asked.margin, std::move(drift), std::move(outlines), std::move(standings),
                          std::move(corners)};
    std::vector<Contact> contacts = joined(perBatch);
    const double ended = handOver(model, blocks, before, asked.underWay, contacts);
    if (asked.released) *asked.released += std::accumulate(lost.begin(), lost.end(), ended);
    dropHeldCorners(model, contacts);
    if (asked.first) joinBondedFaces(model, blocks, contacts);
    return contacts;
}

std::vector<Contact> findContacts(const Model& model, const std::vector<BlockMotion>& blocks,
                                  const std::vector<Contact>& before, double margin, bool first) {
    return findContacts(model, blocks, before, {.margin = margin, .first = first});
}

bool entrancesHold(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts,
                   const FoundCorners& found, const Eigen::VectorXd& path, double deep) {
    const PhaseScope phase(Phase::Search);
    const std::vector<Drift> drift = driftOf(blocks, &path);
    const OtherPath other(model, found, drift);
    const auto searchOf = [&](std::span<const Contact> own) {
        return CandidateSearch{model, blocks, own, drift, found.outlines, found.standings, found.margin};
    };
    const auto isSame = [&](const FoundCorners::Batch& batch) {
        return std::ranges::all_of(batch.pairs, [&](const FoundCorners::Pair& pair) {
            return !other.mayDiffer(pair) ||
                   findsTheSame(searchOf(contactsOfPair(contacts, {pair.a, pair.b})), batch, pair, other.isFar(pair));
        });
    };
    if (std::ranges::all_of(found.batches, isSame)) return true;
    std::vector<std::vector<Contact>> perBatch(found.batches.size());
    forEach(found.batches.size(), 1, [&](std::size_t i) {
        for (const FoundCorners::Pair& pair : found.batches[i].pairs) {
            if (!other.isFar(pair) && pair.begin == pair.end) continue;
            const CandidateSearch search = searchOf(contactsOfPair(contacts, {pair.a, pair.b}));
            addContactsOn(search, found.batches[i], pair, other.isFar(pair), perBatch[i]);
        }
    });
    std::vector<Contact> now = joined(perBatch);
    handOver(model, blocks, contacts, false, now);
    dropHeldCorners(model, now);
    return Entrances{model, blocks, drift, deep}.same(contacts, now);
}

}  // namespace keyblock
