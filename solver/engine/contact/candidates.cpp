// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/candidates.h"

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

namespace keyblock {
namespace {

constexpr double slackShare = 1e-5;  // of the smaller block's size
constexpr double deepest = 0.25;  // of the block's size: a deeper corner is not in contact with this edge
constexpr double pressed = 1e-3;  // of the smaller block's size: a corner no deeper than this may press on the edge
constexpr double sliver = -0.9;  // largest cosine between the outward normals of a sliver's two long sides
constexpr double infinity = std::numeric_limits<double>::infinity();

/// An edge that a corner is in front of, at present or along its path.
struct Faced {
    int turn = -1;  // as in NearEdge
    double gap = 0.0, along = 0.0;  // at present [m]
    double gapEnd = 0.0;  // at the end of the path [m]
    const Edge* edge = nullptr;
    bool flush = false;  // `Entrance::goesOn`, where there are several such edges

    bool isBehind() const { return gap <= 0.0; }

    /// Fraction of the path at which the corner crosses the line of the edge; 0 if it is already behind it, infinite if
    /// it never crosses it.
    double crossing() const { return isBehind() ? 0.0 : gapEnd < 0.0 ? gap / (gap - gapEnd) : infinity; }
};

using FacedEdges = boost::container::small_vector<Faced, 4>;  // seldom more

Point driftAt(const BlockMotion& block, const Drift& drift, const Point& p) {
    return drift.shift + drift.turn * turnLeft(p - block.centroid);
}

/// True if the corner can be in front of the edge: its neighbours lie on the outer side of the edge. Where an edge of
/// the corner is glued to the next cell, the face continues straight there.
bool facesEdge(const std::vector<Point>& corners, const std::vector<char>& inner, int corner, const Edge& edge) {
    const int n = static_cast<int>(corners.size()), before = (corner + n - 1) % n;
    const Point& p = corners[corner];
    Point back = corners[before] - p, on = corners[(corner + 1) % n] - p;
    if (!inner.empty() && inner[before] && inner[corner]) return false;
    if (!inner.empty() && inner[before]) back = -on;
    else if (!inner.empty() && inner[corner]) on = -back;
    return std::ranges::none_of(std::array{back, on}, [&](const Point& away) {
        const double out = edge.outward.dot(away);
        return out < 0.0 && out < -angleSlack * away.norm();
    });
}

/// True if each edge lies on the outer side of the other, like the sides of a notch.
bool faceEachOther(const Edge& first, const Edge& second) {
    const auto before = [](const Edge& edge, const Edge& other) {
        return edge.outward.dot(other.start + 0.5 * other.length * other.along - edge.start) > 0.0;
    };
    return before(first, second) && before(second, first);
}

/// True if the corner is on the far side of a sliver; the thickness of the sliver is then not a penetration of this
/// edge.
bool isBehindSliver(const std::vector<Edge>& sides, const Edge& edge, const Point& p, double over) {
    for (const Edge& side : sides) {
        const Point from = p - side.start;
        const double along = side.along.dot(from);
        if (side.outward.dot(edge.outward) < sliver && std::abs(side.outward.dot(from)) <= over && along >= -over &&
            along <= side.length + over)
            return true;
    }
    return false;
}

/// The previous contact of a corner with the edge that starts at a turn of block `b`; null if there was none.
const Contact* previousOf(const CandidateSearch& search, int a, int corner, int b, int turn) {
    return contactAt(search.before, {a, corner, b, search.model.blocks[b].turns[turn]});
}

/// True if the corner was in contact with the edge and may still be. At the tip of a wedge, a corner pressed into the
/// edge is deeper than the tip is thick, but it has not passed through.
bool isPressed(const CandidateSearch& search, int a, int corner, int b, int turn, double gap) {
    const Contact* old = previousOf(search, a, corner, b, turn);
    if (!old) return false;
    const double most = pressed * std::min(search.model.blocks[a].size, search.model.blocks[b].size);
    return old->normalForce > 0.0 || std::min(gap, gap - old->gapOffset) >= -most;
}

/// Displacement of a corner of block A relative to block B.
Point movesOf(const CandidateSearch& search, int a, int corner, int b) {
    const Point& p = search.blocks[a].corners[corner];
    return driftAt(search.blocks[a], search.drift[a], p) - driftAt(search.blocks[b], search.drift[b], p);
}

/// True if the corner is within `over` of the edge along it, at present or after it has moved.
bool isInFront(const Edge& edge, double along, const Point& moves, double over) {
    const double alongEnd = along + edge.along.dot(moves);
    return std::max(along, alongEnd) >= -over && std::min(along, alongEnd) <= edge.length + over;
}

/// The near edges that a corner is in front of. \param allowed reduced to the change of the relative displacement [m]
/// from which on the corner may be in front of other edges.
FacedEdges facedEdges(const CandidateSearch& search, int a, int corner, int b, std::span<const NearEdge> near,
                      double& allowed) {
    const Point moves = movesOf(search, a, corner, b);
    const double over = search.slack(a, b);
    FacedEdges faced;
    for (const NearEdge& one : near) {
        if (one.behind && !isPressed(search, a, corner, b, one.turn, one.gap)) continue;
        const Edge& edge = search.outlines[b].runs[one.turn];
        const double alongEnd = one.along + edge.along.dot(moves);
        if (one.along < -over) allowed = std::min(allowed, std::abs(alongEnd + over));
        else if (one.along > edge.length + over) allowed = std::min(allowed, std::abs(alongEnd - edge.length - over));
        if (isInFront(edge, one.along, moves, over))
            faced.push_back({one.turn, one.gap, one.along, one.gap + edge.outward.dot(moves), &edge});
    }
    return faced;
}

/// Decides through which of two edges at a convex corner of block B the corner of block A enters.
class Entrance {
public:
    Entrance(const CandidateSearch& search, int a, int corner, int b)
        : search_(search), a_(a), corner_(corner), b_(b), over_(search.slack(a, b)) {}

    /// True if the corner enters through `x` rather than through `y`.
    bool by(const Faced& x, const Faced& y) const {
        if (x.flush != y.flush) return x.flush;
        if (search_.estimated && isAhead(x) && isAhead(y))
            if (const bool oldX = previous(x); oldX != static_cast<bool>(previous(y))) return oldX;
        const double tx = x.crossing(), ty = y.crossing();
        if (tx == 0.0 && ty == 0.0) {
            if (const bool oldX = carries(x); oldX != carries(y)) return oldX;
        } else if (tx != infinity && ty != infinity) {
            const double apart = std::abs(tx - ty) * std::max(x.gap - x.gapEnd, y.gap - y.gapEnd);
            if (apart > over_) return tx > ty;
        } else if (tx != ty) {
            return tx > ty;
        }
        return std::tuple(-x.gapEnd, x.turn) < std::tuple(-y.gapEnd, y.turn);
    }

    /// Change of the relative displacement [m] up to which it certainly enters through the same one of the two.
    double allowedChange(const Faced& x, const Faced& y) const {
        if (x.flush != y.flush) return infinity;
        if (!x.isBehind() && !y.isBehind()) return 0.0;
        const double apart = 0.5 * std::abs(x.gapEnd - y.gapEnd);
        if (x.isBehind() && y.isBehind()) return carries(x) != carries(y) ? infinity : apart;
        const Faced &behind = x.isBehind() ? x : y, &ahead = x.isBehind() ? y : x;
        if (ahead.gap > 2.0 * over_) return infinity;  // it enters through the edge that it is in front of
        return std::max(ahead.gapEnd > behind.gapEnd ? apart : 0.0, ahead.gapEnd);
    }

    /// Change of the relative displacement [m] up to which `grazes` certainly has the same result.
    double allowedChange(const Faced& f) const {
        const bool atEnd = std::min(std::abs(f.along), std::abs(f.edge->length - f.along)) <= over_;
        const bool anyPath = !atEnd || f.gap < -search_.model.tolerance;
        return anyPath ? infinity : std::abs(f.gapEnd + search_.model.tolerance);
    }

    /// True if the corner, or the corner of B at the near end of the edge, already rests on something flush with this
    /// edge.
    bool goesOn(const Faced& f) const {
        if (std::abs(f.gap) > over_) return false;
        const std::vector<int>& turns = search_.model.blocks[b_].turns;
        const bool nearStart = f.along < 0.5 * f.edge->length;
        const int end = turns[(static_cast<std::size_t>(f.turn) + (nearStart ? 0 : 1)) % turns.size()];
        return search_.standings.holdsUp(a_, corner_, f.edge->outward) ||
               search_.standings.holdsUp(b_, end, -f.edge->outward);
    }

    /// True if the corner only grazes the end of this edge and rests on the flush face next to it.
    bool grazes(const Faced& f) const {
        if (std::min(f.gap, f.gapEnd) >= -search_.model.tolerance) return false;
        const std::vector<int>& turns = search_.model.blocks[b_].turns;
        const int count = static_cast<int>(turns.size());
        for (const auto& [at, neighbour] : {std::pair(f.along, (f.turn + count - 1) % count),
                                            std::pair(f.edge->length - f.along, (f.turn + 1) % count)}) {
            if (std::abs(at) > over_) continue;
            Faced next;
            next.turn = neighbour;
            next.edge = &search_.outlines[b_].runs[neighbour];
            const std::vector<Point>& own = search_.blocks[a_].corners;
            const Point from = own[corner_] - next.edge->start;
            next.gap = next.edge->outward.dot(from), next.along = next.edge->along.dot(from);
            const bool round = !faceEachOther(*f.edge, *next.edge) &&
                               facesEdge(own, search_.model.blocks[a_].inner, corner_, *next.edge);
            if (round && goesOn(next) && !goesOn(f)) return true;
        }
        return false;
    }

private:
    /// True if the corner is outside the line of the edge, but barely.
    bool isAhead(const Faced& f) const { return f.gap > 0.0 && f.gap <= over_; }

    /// The previous contact of the corner with this edge; null if there was none.
    const Contact* previous(const Faced& f) const { return previousOf(search_, a_, corner_, b_, f.turn); }

    bool carries(const Faced& f) const {
        if (f.gap < -over_) return false;
        const Contact* old = previous(f);
        return old && (old->normalForce > 0.0 || old->bonded);
    }

    const CandidateSearch& search_;
    int a_, corner_, b_;
    double over_;
};

std::pair<int, int> pairOf(const Contact& c) { return {std::min(c.blockA, c.blockB), std::max(c.blockA, c.blockB)}; }

Candidate candidateOf(const CandidateSearch& search, int a, int corner, int b, const Faced& faced) {
    const int edge = search.model.blocks[b].turns[faced.turn];
    return {a, corner, b, edge, faced.gap, faced.along / edgeLength(search.blocks[b].corners, edge)};
}

}  // namespace

std::vector<Drift> driftOf(const std::vector<BlockMotion>& blocks, const Eigen::VectorXd* path) {
    std::vector<Drift> drift(blocks.size());
    for (std::size_t i = 0; path && i < blocks.size(); ++i) {
        const Vector6 d = path->segment<6>(6 * static_cast<Eigen::Index>(i));
        drift[i] = {d[0] * blocks[i].axis + d[1] * turnLeft(blocks[i].axis), d[2]};
    }
    return drift;
}

std::vector<Outline> outlinesOf(const Model& model, const std::vector<BlockMotion>& blocks) {
    std::vector<Outline> outlines(blocks.size());
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        outlines[i].box = boxOf(blocks[i].corners);
        outlines[i].across = (outlines[i].box.max - outlines[i].box.min).norm();
        const int count = static_cast<int>(model.blocks[i].turns.size());
        outlines[i].runs.reserve(count);
        for (int turn = 0; turn < count; ++turn)
            outlines[i].runs.push_back(runOf(model.blocks[i], blocks[i].corners, turn));
    }
    return outlines;
}

Standings::Standings(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& contacts)
    : first_(blocks.size() + 1, 0) {
    const auto supports = [](const Contact& c) { return c.normalForce > 0.0 || c.bonded; };
    for (const Contact& c : contacts)
        if (supports(c)) first_[c.blockA + 1] += 1, first_[c.blockB + 1] += 2;
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    entries_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (const Contact& c : contacts) {
        if (!supports(c)) continue;
        const std::vector<int>& turns = model.blocks[c.blockB].turns;
        const auto start = std::lower_bound(turns.begin(), turns.end(), c.edge);
        const int end = start + 1 >= turns.end() ? turns.front() : *(start + 1);
        const Point outward = edgeOf(blocks[c.blockB].corners, c.edge).outward;
        entries_[next[c.blockA]++] = {c.corner, outward};
        for (const int corner : {c.edge, end}) entries_[next[c.blockB]++] = {corner, -outward};
    }
}

bool Standings::holdsUp(int block, int corner, const Point& normal) const {
    return std::any_of(entries_.begin() + static_cast<std::ptrdiff_t>(first_[block]),
                       entries_.begin() + static_cast<std::ptrdiff_t>(first_[block + 1]), [&](const Entry& e) {
                           return e.corner == corner && e.outward.dot(normal) > 0.0 &&
                                  std::abs(cross(e.outward, normal)) <= angleSlack;
                       });
}

double slackBetween(const Model& model, int a, int b) {
    return slackShare * std::min(model.blocks[a].size, model.blocks[b].size) + model.tolerance;
}

double deepestNear(const BlockModel& block) { return deepest * block.size; }

Box CandidateSearch::reachOf(int a, int b) const {
    constexpr double rounding = 1.0 + 1e-9;  // no corner may be skipped because of rounding
    const double across = outlines[a].across;
    const double apart = (blocks[a].centroid - blocks[b].centroid).norm() + across;
    const double moves = (drift[a].shift - drift[b].shift).norm() + std::abs(drift[a].turn) * across +
                         std::abs(drift[b].turn) * apart;
    return grown(outlines[b].box, rounding * (2.0 * (slack(a, b) + margin) + moves));
}

void CandidateSearch::addNearEdges(int a, int corner, int b, std::vector<NearEdge>& near) const {
    const double moves = movesOf(*this, a, corner, b).norm();
    if (!isNearBox(a, corner, b, std::max(0.0, moves - margin))) return;
    for (int turn = 0; turn < static_cast<int>(outlines[b].runs.size()); ++turn) addIfNear(a, corner, b, turn, near);
}

void CandidateSearch::addNearEdges(int a, int corner, int b, std::span<const int> turns,
                                   std::vector<NearEdge>& near) const {
    if (!isNearBox(a, corner, b, 0.0)) return;
    for (const int turn : turns) addIfNear(a, corner, b, turn, near);
}

/// False if the corner is so far outside the box of block B that it is near none of its edges.
/// \param beyond the part of the path's length that exceeds the margin [m].
bool CandidateSearch::isNearBox(int a, int corner, int b, double beyond) const {
    const Point& p = blocks[a].corners[corner];
    return meets(grown(outlines[b].box, 2.0 * (slack(a, b) + margin) + beyond), {p, p});
}

void CandidateSearch::addIfNear(int a, int corner, int b, int turn, std::vector<NearEdge>& near) const {
    const std::vector<char>& inner = model.blocks[b].inner;
    if (!inner.empty() && inner[model.blocks[b].turns[turn]]) return;  // not a face: glued to the next cell
    const std::vector<Point>& own = blocks[a].corners;
    const Edge& edge = outlines[b].runs[turn];
    const Point from = own[corner] - edge.start;
    const double gap = edge.outward.dot(from), along = edge.along.dot(from);
    if (gap > margin || gap < -deepestNear(model.blocks[b])) return;
    const double over = slack(a, b), room = over + margin;
    if ((along < -room || along > edge.length + room) && !isInFront(edge, along, movesOf(*this, a, corner, b), over))
        return;
    if (!facesEdge(own, model.blocks[a].inner, corner, edge)) return;
    // For example, a top corner of a brick on a wide slab is also in front of the slab's bottom edge, but from
    // above the slab. On the boundary, a corner is at another edge.
    const auto isBehind = [&] {
        return locate(blocks[b].corners, own[corner], over) != Side::Inside ||
               isBehindSliver(outlines[b].runs, edge, own[corner], over);
    };
    near.push_back({turn, gap, along, gap < -over && isBehind()});
}

double CandidateSearch::addEntrances(int a, int corner, int b, std::span<const NearEdge> near,
                                     std::vector<Candidate>& found) const {
    double allowed = infinity;
    FacedEdges faced = facedEdges(*this, a, corner, b, near, allowed);
    const Entrance entrance(*this, a, corner, b);
    if (faced.size() > 1)
        for (Faced& one : faced) one.flush = entrance.goesOn(one);
    boost::container::small_vector<char, 4> beaten(faced.size(), 0);
    for (std::size_t i = 0; i < faced.size(); ++i)
        for (std::size_t j = i + 1; j < faced.size(); ++j) {
            if (faceEachOther(*faced[i].edge, *faced[j].edge)) continue;
            beaten[entrance.by(faced[i], faced[j]) ? j : i] = 1;
            allowed = std::min(allowed, entrance.allowedChange(faced[i], faced[j]));
        }
    for (std::size_t i = 0; i < faced.size(); ++i) {
        if (!beaten[i] && !entrance.grazes(faced[i])) found.push_back(candidateOf(*this, a, corner, b, faced[i]));
        allowed = std::min(allowed, entrance.allowedChange(faced[i]));
    }
    return allowed;
}

const Contact* contactAt(std::span<const Contact> contacts, const ContactPlace& place) {
    const auto found = std::lower_bound(contacts.begin(), contacts.end(), place,
                                        [](const Contact& c, const ContactPlace& at) { return ContactPlace(c) < at; });
    return found != contacts.end() && ContactPlace(*found) == place ? &*found : nullptr;
}

std::span<const Contact> contactsOfPair(std::span<const Contact> contacts, const std::pair<int, int>& pair) {
    const auto begin = std::ranges::lower_bound(contacts, pair, {}, pairOf);
    return {begin, std::find_if(begin, contacts.end(), [&](const Contact& c) { return pairOf(c) != pair; })};
}

std::vector<std::span<const Contact>> contactsOfPairs(std::span<const Contact> contacts,
                                                      std::span<const std::pair<int, int>> pairs) {
    std::vector<std::span<const Contact>> parts;
    parts.reserve(pairs.size());
    auto next = contacts.begin();
    for (const std::pair<int, int>& pair : pairs) {
        const auto first = std::find_if(next, contacts.end(), [&](const Contact& c) { return pairOf(c) >= pair; });
        next = std::find_if(first, contacts.end(), [&](const Contact& c) { return pairOf(c) != pair; });
        parts.emplace_back(first, next);
    }
    return parts;
}

Edge runOf(const BlockModel& block, const std::vector<Point>& corners, int turn) {
    const std::size_t start = turn, next = start + 1;
    return edgeBetween(corners[block.turns[start]], corners[block.turns[next < block.turns.size() ? next : 0]]);
}

}  // namespace keyblock
