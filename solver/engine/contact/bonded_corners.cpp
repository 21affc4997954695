// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/bonded_corners.h"

#include <algorithm>
#include <utility>

namespace keyblock {
namespace {

constexpr double sameCorner = 10.0;  // times the geometric tolerance

/// Initial position of the contact's corner [m].
Point startOf(const Model& model, const Contact& c) {
    const BlockModel& block = model.blocks[c.blockA];
    return block.centroid + block.shape[c.corner];
}

/// A bond between two blocks at a point.
struct Bond {
    int block = -1, other = -1;
    Point place{0.0, 0.0};  // initial position [m]
};

/// The bonds of all blocks, sorted by block, including those between glued cells. Empty if no contact is bonded.
std::vector<Bond> bondsOf(const Model& model, const std::vector<Contact>& contacts) {
    std::vector<Bond> bonds;
    const auto add = [&](int a, int b, const Point& place) {
        bonds.push_back({a, b, place});
        bonds.push_back({b, a, place});
    };
    for (const Contact& c : contacts)
        if (c.bonded) add(c.blockA, c.blockB, startOf(model, c));
    if (bonds.empty()) return bonds;
    for (const GlueModel& glue : model.glue) {
        const Point middle = model.blocks[glue.a].centroid + glue.placeA, half = 0.5 * glue.length * glue.along;
        add(glue.a, glue.b, middle - half);
        add(glue.a, glue.b, middle + half);
    }
    std::stable_sort(bonds.begin(), bonds.end(), [](const Bond& x, const Bond& y) { return x.block < y.block; });
    return bonds;
}

/// True if a chain of bonds at the corner of `c` leads from block A to block B.
bool heldRound(const Model& model, const std::vector<Bond>& bonds, const Contact& c) {
    const Point place = startOf(model, c);
    std::vector<int> reached{c.blockA};
    for (std::size_t i = 0; i < reached.size(); ++i) {
        const auto before = [](const Bond& bond, int block) { return bond.block < block; };
        auto bond = std::lower_bound(bonds.begin(), bonds.end(), reached[i], before);
        for (; bond != bonds.end() && bond->block == reached[i]; ++bond) {
            if ((bond->place - place).norm() > sameCorner * model.tolerance) continue;
            if (bond->other == c.blockB) return true;
            if (std::find(reached.begin(), reached.end(), bond->other) == reached.end()) reached.push_back(bond->other);
        }
    }
    return false;
}

}  // namespace

void dropHeldCorners(const Model& model, std::vector<Contact>& contacts) {
    const std::vector<Bond> bonds = bondsOf(model, contacts);
    if (bonds.empty()) return;
    std::erase_if(contacts, [&](const Contact& c) {
        const bool carries = c.bonded || c.normalForce != 0.0 || c.shearForce != 0.0;
        return !carries && heldRound(model, bonds, c);
    });
}

}  // namespace keyblock
