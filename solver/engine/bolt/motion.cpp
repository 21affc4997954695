// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/motion.h"

#include <cmath>

namespace keyblock {
namespace {

/// The block with which each node rotates: its own or, without one, that of the next node along the unbroken bar; −1 if
/// there is none.
std::vector<int> carriersOf(const BoltMotion& bolt) {
    std::vector<int> carriers;
    for (const BoltNode& node : bolt.nodes) carriers.push_back(node.slot < 0 ? -1 : bolt.slots[node.slot].block);
    const auto pass = [&](std::size_t from, std::size_t to, std::size_t element) {
        if (carriers[to] < 0 && !bolt.elements[element].ruptured) carriers[to] = carriers[from];
    };
    for (std::size_t e = 0; e < bolt.elements.size(); ++e) pass(e, e + 1, e);
    for (std::size_t e = bolt.elements.size(); e-- > 0;) pass(e + 1, e, e);
    return carriers;
}

/// A step is solved with linear displacements, but blocks then turn by the exact rotation. The nodes that they carry
/// must do the same; otherwise a bolt in a spinning block would be pulled out a little at every step. \return the
/// displacement of `x` in excess of its linear displacement.
Point roundTheBend(const BlockMotion& block, double turn, const Point& x) {
    const Point arm = x - block.centroid;
    return (std::cos(turn) - 1.0) * arm + (std::sin(turn) - turn) * turnLeft(arm);
}

void moveNodes(State& state, BoltMotion& bolt, const Eigen::VectorXd& d, Eigen::Index at) {
    const std::vector<int> carriers = acts(bolt) ? carriersOf(bolt) : std::vector<int>(bolt.nodes.size(), -1);
    for (std::size_t n = 0; n < bolt.nodes.size(); ++n, at += 3) {
        BoltNode& node = bolt.nodes[n];
        const int block = carriers[n];
        if (block >= 0) node.x += roundTheBend(state.blocks[block], d[6 * block + 2], node.x);
        node.x += d.segment<2>(at);
        node.angle += d[at + 2];
    }
}

}  // namespace

void moveBolts(const Model& model, State& state, const Eigen::VectorXd& d) {
    Eigen::Index at = 6 * static_cast<Eigen::Index>(model.blocks.size());
    for (BoltMotion& bolt : state.bolts) {
        moveNodes(state, bolt, d, at);
        at += 3 * static_cast<Eigen::Index>(bolt.nodes.size());
    }
}

}  // namespace keyblock
