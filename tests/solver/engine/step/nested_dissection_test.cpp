// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Groups of bodies for elimination: each border separates what it should.

#include "solver/engine/step/nested_dissection.h"
#include "solver/engine/step/step_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <vector>

namespace keyblock {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

struct Net {
    std::vector<Eigen::Vector2d> places;
    Pairs pairs;
};

/// A wall in running bond.
Net wall(int width, int height) {
    Net net;
    const auto body = [&](int row, int k) { return row * width + k; };
    for (int row = 0; row < height; ++row)
        for (int k = 0; k < width; ++k) {
            net.places.emplace_back(k + 0.5 * (row % 2), 0.5 * row);
            net.pairs.emplace_back(body(row, k), body(row, k));
            if (k + 1 < width) net.pairs.emplace_back(body(row, k + 1), body(row, k));
            if (row + 1 == height) continue;
            net.pairs.emplace_back(body(row + 1, k), body(row, k));
            const int other = row % 2 == 0 ? k - 1 : k + 1;
            if (other >= 0 && other < width) net.pairs.emplace_back(body(row + 1, other), body(row, k));
        }
    return net;
}

/// Numbers of bodies in the connected parts of a net without the bodies of group `without`.
std::vector<int> partsWithout(const Net& net, const std::vector<int>& groups, int without) {
    std::vector<int> root(net.places.size());
    std::iota(root.begin(), root.end(), 0);
    const std::function<int(int)> rootOf = [&](int i) { return root[i] == i ? i : root[i] = rootOf(root[i]); };
    for (const auto& [a, b] : net.pairs)
        if (groups[a] != without && groups[b] != without) root[rootOf(a)] = rootOf(b);
    std::vector<int> size(root.size(), 0);
    for (std::size_t i = 0; i < root.size(); ++i)
        if (groups[i] != without) ++size[rootOf(static_cast<int>(i))];
    std::erase(size, 0);
    return size;
}

/// The last group is the border of two halves, about as long as the wall is high.
TEST(NestedDissection, TheLastGroupSeparatesHalves) {
    const Net net = wall(60, 40);
    const std::vector<int> groups = nestedDissection(net.places, net.pairs);
    ASSERT_EQ(groups.size(), net.places.size());
    const int last = std::ranges::max(groups);
    EXPECT_LE(std::ranges::count(groups, last), 41);
    const std::vector<int> parts = partsWithout(net, groups, last);
    EXPECT_EQ(parts.size(), 2u);
    EXPECT_LE(std::ranges::max(parts), 1200);
    EXPECT_GE(std::ranges::min(parts), 1100);
}

/// Groups are numbered without gaps. Leaves are small and are not connected with each other.
TEST(NestedDissection, LeavesAreConnectedThroughBordersOnly) {
    const Net net = wall(60, 40);
    const std::vector<int> groups = nestedDissection(net.places, net.pairs);
    const int count = std::ranges::max(groups) + 1;
    std::vector<int> size(count, 0);
    for (const int group : groups) ++size[group];
    EXPECT_GT(std::ranges::min(size), 0);
    std::vector<char> isBorder(count, 0);  // groups connected with an earlier one
    for (const auto& [a, b] : net.pairs)
        if (groups[a] != groups[b]) isBorder[std::max(groups[a], groups[b])] = 1;
    const auto leaves = std::ranges::count(isBorder, 0);
    EXPECT_EQ(leaves, 32);  // 2,400 bodies divided five times
    for (int group = 0; group < count; ++group) EXPECT_LE(size[group], isBorder[group] ? 41 : 100);
}

/// A body that is connected to all bodies of the other half is the border alone.
TEST(NestedDissection, TheBorderLiesInTheHalfWithFewerBodies) {
    for (const int hub : {0, 299}) {
        Net net;
        for (int i = 0; i < 300; ++i) net.places.emplace_back(i, 0.0);
        for (int i = 0; i < 300; ++i)
            if ((i < 150) != (hub < 150)) net.pairs.emplace_back(hub, i);
        const std::vector<int> groups = nestedDissection(net.places, net.pairs);
        EXPECT_EQ(groups[hub], std::ranges::max(groups));
        EXPECT_EQ(std::ranges::count(groups, groups[hub]), 1);
    }
}

TEST(NestedDissection, AcceptsAnyNet) {
    EXPECT_TRUE(nestedDissection({}, {}).empty());
    const std::vector<Eigen::Vector2d> same(500, Eigen::Vector2d(1.0, 1.0));
    EXPECT_EQ(nestedDissection(same, {}).size(), 500u);  // nothing is connected
    Pairs all;
    for (int i = 0; i < 500; ++i)
        for (int k = 0; k < i; ++k) all.emplace_back(i, k);
    const std::vector<int> groups = nestedDissection(same, all);  // everything is
    EXPECT_EQ(groups.size(), 500u);
    EXPECT_GE(std::ranges::min(groups), 0);
    EXPECT_LT(std::ranges::max(groups), 500);
}

/// A step of the wall in which the first `fixed` blocks are fixed and the next one may not move sideways.
StepProblem stepOf(const Net& net, int fixed) {
    StepProblem problem;
    problem.blocks = static_cast<int>(net.places.size());
    problem.places = net.places;
    problem.known.assign(problem.unknowns(), 0);
    std::fill_n(problem.known.begin(), 6 * fixed + 1, 1);
    for (const auto& [a, b] : net.pairs) {
        if (a == b) continue;
        Link link;
        link.a = a, link.b = b;
        problem.links.push_back(link);
    }
    return problem;
}

/// Each unknown that is not prescribed has the group of its block, numbered without the blocks that are fixed.
TEST(EliminationGroups, LeaveOutWhatIsFixed) {
    constexpr int fixed = 800;
    const StepProblem problem = stepOf(wall(80, 70), fixed);
    const std::vector<int> groups = eliminationGroups(problem);
    const int free = problem.blocks - fixed;
    ASSERT_EQ(static_cast<int>(groups.size()), 6 * free - 1);
    std::vector<int> size(std::ranges::max(groups) + 1, 0);
    for (const int group : groups) ++size[group];
    EXPECT_GT(std::ranges::min(size), 0);
    for (int i = 5; i < 6 * free - 1; ++i) EXPECT_EQ(groups[i], groups[5 + (i - 5) / 6 * 6]) << i;
}

TEST(EliminationGroups, AreNotMadeForFewBodies) {
    EXPECT_TRUE(eliminationGroups(stepOf(wall(30, 30), 0)).empty());
    EXPECT_TRUE(eliminationGroups(stepOf(wall(80, 70), 5590)).empty());
}

/// With the positions of its bodies, the matrix of a large step has another order, and another factor, than without.
TEST(EliminationGroups, OrderTheMatrixOfAStep) {
    const auto entries = [](const StepProblem& problem) {
        StepMatrix matrix;
        matrix.begin(problem, LinkRows(problem));
        return matrix.factorEntries();
    };
    StepProblem problem = stepOf(wall(100, 80), 100);
    problem.blockStiffness.assign(problem.blocks, Matrix6::Identity());
    problem.value = problem.load = Eigen::VectorXd::Zero(problem.unknowns());
    problem.weight = Eigen::VectorXd::Ones(problem.unknowns());
    const double grouped = entries(problem);
    problem.places.clear();
    EXPECT_NE(grouped, entries(problem));
}

}  // namespace
}  // namespace keyblock
