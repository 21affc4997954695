// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/elimination_tree.h"

#include "solver/engine/step/supernode.h"

#include <algorithm>
#include <cstddef>

namespace keyblock {
namespace {

/// Operations, as a sum of width · height², from which a factor is divided among threads: those of about 2,000 blocks.
constexpr double worthThreads = 3e8;
/// Share of the operations that a subtree for one thread may have at most and at least.
constexpr double mostOfSubtree = 0.3, leastOfSubtree = 0.005;

/// Operations of the supernodes, summed over the subtree below each.
struct TreeWork {
    std::vector<int> parent;  // per supernode; −1: root
    std::vector<int> begin;  // per supernode: first supernode of its subtree
    std::vector<double> work;  // of the subtree
    bool isPostordered = true;  // each subtree is a sequence of supernodes
};

TreeWork treeWork(const cholmod_factor& factor) {
    const std::vector<int> supernodeOf = supernodeOfRows(factor);
    const auto count = static_cast<int>(factor.nsuper);
    TreeWork tree{std::vector<int>(factor.nsuper, -1), {}, std::vector<double>(factor.nsuper, 0.0)};
    std::vector<int> size(factor.nsuper, 1);
    for (int s = 0; s < count; ++s) tree.begin.push_back(s);
    for (int s = 0; s < count; ++s) {
        const Supernode node = supernode(factor, static_cast<std::size_t>(s));
        tree.work[s] += static_cast<double>(node.width) * node.height * node.height;
        tree.isPostordered = tree.isPostordered && size[s] == s - tree.begin[s] + 1;
        if (node.height == node.width) continue;
        const int parent = tree.parent[s] = supernodeOf[node.rows[node.width]];
        tree.work[parent] += tree.work[s];
        tree.begin[parent] = std::min(tree.begin[parent], tree.begin[s]);
        size[parent] += size[s];
    }
    return tree;
}

}  // namespace

std::vector<int> supernodeOfRows(const cholmod_factor& factor) {
    const auto* super = static_cast<const int*>(factor.super);
    std::vector<int> supernodeOf(factor.n);
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        std::fill(supernodeOf.begin() + super[s], supernodeOf.begin() + super[s + 1], static_cast<int>(s));
    return supernodeOf;
}

std::vector<Subtree> subtreesForThreads(const cholmod_factor& factor) {
    const TreeWork tree = treeWork(factor);
    double whole = 0.0;
    for (std::size_t s = 0; s < factor.nsuper; ++s)
        if (tree.parent[s] < 0) whole += tree.work[s];
    if (whole < worthThreads || !tree.isPostordered) return {};
    std::vector<Subtree> subtrees;
    for (std::size_t s = 0; s < factor.nsuper; ++s) {
        const bool isPart = tree.work[s] <= mostOfSubtree * whole && tree.work[s] >= leastOfSubtree * whole;
        const bool within = tree.parent[s] >= 0 && tree.work[tree.parent[s]] <= mostOfSubtree * whole;
        if (isPart && !within) subtrees.push_back({tree.begin[s], static_cast<int>(s) + 1});
    }
    return subtrees;
}

}  // namespace keyblock
