// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Candidate contacts: the edges of a block that a corner of another block faces, and
// the edge through which it would enter. Near a corner of the other block there may be
// several such edges; the path over the step then decides. A corner that slides along a
// face continues to slide onto the face of the next block if the two are flush.
#pragma once

#include "geometry/polygon.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/model/state.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace keyblock {

/// First-order displacement of a block over the coming step.
struct Drift {
    Point shift{0.0, 0.0};  // of the centroid [m]
    double turn = 0.0;  // [rad]
};

/// Drift of every block.
/// \param path the displacement over the step, six unknowns per block; null: at rest.
std::vector<Drift> driftOf(const std::vector<BlockMotion>& blocks, const Eigen::VectorXd* path);

/// Current outline of a block: its bounding box, and its straight runs, one for each entry of BlockModel::turns.
struct Outline {
    Box box;
    double across = 0.0;  // diagonal of the box [m]
    std::vector<Edge> runs;
};

std::vector<Outline> outlinesOf(const Model& model, const std::vector<BlockMotion>& blocks);

/// A corner of block A in front of an edge of block B, without a history.
struct Candidate {
    int blockA = -1, corner = -1, blockB = -1, edge = -1;
    double gap = 0.0;  // [m]
    double place = 0.0;  // position of the corner along the edge [0 … 1]
};

/// An edge of block B that a corner of block A may be in front of, on any path within the margin of the search.
struct NearEdge {
    int turn = -1;  // index in the block's `turns` at which the edge begins
    double gap = 0.0, along = 0.0;  // position of the corner relative to the edge [m]
    bool behind = false;  // the corner has passed the block, unless a contact shows that it is pressed into the edge
};

/// Supported corners: for each contact that is compressed or bonded, its corner and both ends of its edge.
class Standings {
public:
    Standings() = default;
    Standings(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& before);

    /// True if the corner is supported by a face whose outward normal is `normal` to within 3°.
    bool holdsUp(int block, int corner, const Point& normal) const;

private:
    struct Entry {
        int corner = -1;
        Point outward{0.0, 0.0};  // normal of the supporting face or, for an end of that face, its opposite
    };

    std::vector<std::size_t> first_;  // per block: its first entry; then the number of entries
    std::vector<Entry> entries_;
};

/// Distance past the end of an edge of block B up to which a corner of block A still counts as resting on it [m].
double slackBetween(const Model& model, int a, int b);

/// Depth behind an edge of the block up to which a corner may be near it [m].
double deepestNear(const BlockModel& block);

struct CandidateSearch {
    const Model& model;
    const std::vector<BlockMotion>& blocks;
    std::span<const Contact> before;  // previous contacts of all blocks, or of blocks A and B only
    const std::vector<Drift>& drift;
    const std::vector<Outline>& outlines;
    const Standings& standings;
    double margin;
    bool estimated = false;  // the path is an estimate: near a corner of block B, the edge of the last contact is kept

    /// The slack between blocks A and B, as `slackBetween` [m].
    double slack(int a, int b) const { return slackBetween(model, a, b); }

    /// The box outside of which no corner of block A can be in contact with block B.
    Box reachOf(int a, int b) const;

    /// Adds the edges of block B near corner `corner` of block A to `near`. They depend on the path only if it is longer
    /// than the margin.
    void addNearEdges(int a, int corner, int b, std::vector<NearEdge>& near) const;

    /// The same among the edges that begin at `turns`. \pre no others are near, and the path is within the margin.
    void addNearEdges(int a, int corner, int b, std::span<const int> turns, std::vector<NearEdge>& near) const;

    /// Adds corner `corner` of block A with each of the near edges of block B through which it would enter.
    /// \return change of the relative displacement over the path up to which the result is certainly the same, if the
    ///         path is within the margin [m]; infinite if it is the same for all these paths.
    double addEntrances(int a, int corner, int b, std::span<const NearEdge> near, std::vector<Candidate>& found) const;

private:
    bool isNearBox(int a, int corner, int b, double beyond) const;
    void addIfNear(int a, int corner, int b, int turn, std::vector<NearEdge>& near) const;
};

/// Sort key of contacts: pair of blocks, then corner, then edge.
struct ContactPlace {
    std::uint64_t pair = 0, corner = 0;
    int edge = -1;

    ContactPlace(int blockA, int cornerOfA, int blockB, int edgeOfB)
        : pair(of(std::min(blockA, blockB), std::max(blockA, blockB))), corner(of(blockA, cornerOfA)), edge(edgeOfB) {}
    explicit ContactPlace(const Contact& c) : ContactPlace(c.blockA, c.corner, c.blockB, c.edge) {}
    explicit ContactPlace(const Candidate& c) : ContactPlace(c.blockA, c.corner, c.blockB, c.edge) {}

    /// Combines two non-negative numbers into one sort key; the first number takes precedence.
    static std::uint64_t of(int first, int second) {
        return (static_cast<std::uint64_t>(first) << 32) + static_cast<std::uint64_t>(second);
    }

    auto operator<=>(const ContactPlace&) const = default;
};

inline bool comesBefore(const Contact& x, const Contact& y) { return ContactPlace(x) < ContactPlace(y); }

/// The contact in a sorted list with this corner and edge; null if there is none.
const Contact* contactAt(std::span<const Contact> contacts, const ContactPlace& place);

/// The contact in a sorted list that has the same corner and edge as a contact or candidate; null if there is none.
inline const Contact* sameContact(std::span<const Contact> contacts, const auto& place) {
    return contactAt(contacts, ContactPlace(place));
}

/// The part of the sorted list `contacts` that is between two blocks.
/// \param pair the smaller number comes first.
std::span<const Contact> contactsOfPair(std::span<const Contact> contacts, const std::pair<int, int>& pair);

/// For each pair of blocks of a sorted list, the part of the sorted list `contacts` that is between them.
/// \param pairs the smaller number of a pair comes first.
std::vector<std::span<const Contact>> contactsOfPairs(std::span<const Contact> contacts,
                                                      std::span<const std::pair<int, int>> pairs);

/// The straight run of the outline that starts at corner `block.turns[turn]`.
/// \param corners current positions of the block's corners [m]
Edge runOf(const BlockModel& block, const std::vector<Point>& corners, int turn);

/// Sine of 3°, the angle up to which two directions are considered parallel.
inline constexpr double angleSlack = 0.0523;

}  // namespace keyblock
