// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which edges of a block a corner of another is in front of, and by which of
// them it comes in. Near a corner of the other block several are in question;
// the path over the step decides, and a corner that slides on a face keeps
// sliding where the next block's face is flush with it.
#pragma once

#include "geometry/polygon.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/model/state.h"

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace keyblock {

/// How a block moves over the step that begins, to first order.
struct Drift {
    Point shift{0.0, 0.0};  // of the centroid [m]
    double turn = 0.0;  // [rad]
};

/// Drift of every block. \param path displacement of the step, six unknowns a block; none: at rest.
std::vector<Drift> driftOf(const std::vector<BlockMotion>& blocks, const Eigen::VectorXd* path);

/// Where a block is: the straight pieces that begin at the corners of its list `turns`, in a box.
struct Outline {
    Box box;
    std::vector<Edge> runs;
};

std::vector<Outline> outlinesOf(const Model& model, const std::vector<BlockMotion>& blocks);

/// Where corners press: of each carrying contact the corner, and the ends of the edge that it rests on.
class Standings {
public:
    Standings(const Model& model, const std::vector<BlockMotion>& blocks, const std::vector<Contact>& before);

    /// True where the corner is held up by something whose outward normal is `normal`, to 3°.
    bool holdsUp(int block, int corner, const Point& normal) const;

private:
    struct Entry {
        int corner = -1;
        Point normal{0.0, 0.0};
    };

    std::vector<std::size_t> first_;  // entry of each block, and one past the last block's
    std::vector<Entry> entries_;
};

struct CandidateSearch {
    const Model& model;
    const std::vector<BlockMotion>& blocks;
    std::span<const Contact> before;  // of all blocks, or of A and B alone
    const std::vector<Drift>& drift;
    const std::vector<Outline>& outlines;
    const Standings& standings;
    double margin;

    /// How far past an edge's end a corner still rests on it [m].
    double slack(int a, int b) const;

    /// Adds the contacts of corner `corner` of A with the edges of B by which it comes in.
    /// \return true where these may be others on another path, on which bodies move by up to the margin to each other
    bool addCorner(int a, int corner, int b, std::vector<Contact>& found) const;
};

/// The contact's own entry in a sorted list; null where it has none.
const Contact* sameContact(std::span<const Contact> contacts, const Contact& contact);

/// The part of a sorted list that lies between two blocks.
std::span<const Contact> contactsBetween(std::span<const Contact> contacts, int a, int b);

/// Place of a contact in the order of contacts: by pair of blocks, then by corner, then by edge.
struct ContactPlace {
    std::uint64_t pair = 0, corner = 0;
    int edge = -1;

    explicit ContactPlace(const Contact& c)
        : pair(of(std::min(c.blockA, c.blockB), std::max(c.blockA, c.blockB))), corner(of(c.blockA, c.corner)), edge(c.edge) {}

    /// Of two numbers that are not negative, the first of which decides.
    static std::uint64_t of(int first, int second) {
        return (static_cast<std::uint64_t>(first) << 32) + static_cast<std::uint64_t>(second);
    }

    auto operator<=>(const ContactPlace&) const = default;
};

inline bool comesBefore(const Contact& x, const Contact& y) { return ContactPlace(x) < ContactPlace(y); }

/// The straight piece of outline that begins at corner `turn` of the block's list `turns`.
Edge runOf(const BlockModel& block, const std::vector<Point>& corners, int turn);

/// Sine of the angle under which directions count as parallel: 3°.
inline constexpr double angleSlack = 0.0523;

}  // namespace keyblock
