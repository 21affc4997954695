// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the nodes of a bolt are put, by hand and by the program.
#include "solver/engine/bolt/bolt_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double dowel = 0.02;

void expectSound(const std::vector<double>& nodes, double length) {
    ASSERT_GE(nodes.size(), 2u);
    EXPECT_EQ(nodes.front(), 0.0);
    EXPECT_EQ(nodes.back(), length);
    for (std::size_t i = 1; i < nodes.size(); ++i) EXPECT_GT(nodes[i], nodes[i - 1]) << i;
}

/// Distance of a joint from the middle of its element, over that element's length.
double offMiddle(const std::vector<double>& nodes, double joint) {
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), joint);
    const double from = *(after - 1), to = *after;
    return std::abs(0.5 * (from + to) - joint) / (to - from);
}

TEST(BoltNodes, GivenDivisionsAreEqual) {
    for (const int divisions : {1, 2, 59, 60, 1000}) {
        const std::vector<double> nodes = boltNodes(2.0, divisions, {1.0}, dowel);
        expectSound(nodes, 2.0);
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>(divisions) + 1);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            EXPECT_NEAR(nodes[i], 2.0 * static_cast<double>(i) / divisions, 1e-15) << i;
    }
}

TEST(BoltNodes, AutomaticOnesAreFineAboutEveryJoint) {
    const std::vector<double> joints{0.31, 0.9, 0.95, 1.7};
    const std::vector<double> nodes = boltNodes(2.0, std::nullopt, joints, dowel);
    expectSound(nodes, 2.0);
    for (const double joint : joints) {
        EXPECT_LT(offMiddle(nodes, joint), 1e-6) << joint;
        for (std::size_t i = 1; i < nodes.size(); ++i) {
            const bool near = nodes[i - 1] < joint + 2.999 * dowel && nodes[i] > joint - 2.999 * dowel;
            if (!near) continue;
            EXPECT_LE(nodes[i] - nodes[i - 1], dowel / 8.0 * (1.0 + 1e-9)) << joint << " to " << nodes[i];
        }
    }
    for (std::size_t i = 1; i < nodes.size(); ++i) EXPECT_LE(nodes[i] - nodes[i - 1], 2.0 / 60.0 * (1.0 + 1e-9));
}

TEST(BoltNodes, JointsCloserThanAnElementKeepClearOfNodes) {
    for (const double apart : {0.1, 0.4, 0.5, 0.6, 0.9, 1.0, 1.1}) {
        const double second = 1.0 + apart * dowel / 8.0;
        const std::vector<double> nodes = boltNodes(2.0, std::nullopt, {1.0, second}, dowel);
        expectSound(nodes, 2.0);
        for (const double joint : {1.0, second}) EXPECT_LT(offMiddle(nodes, joint), 0.45) << apart;
    }
}

TEST(BoltNodes, JointsNearTheEndsStayWithin) {
    for (const double joint : {1e-4, 1e-3, 0.01, 1.99, 1.9999}) {
        const std::vector<double> nodes = boltNodes(2.0, std::nullopt, {joint}, dowel);
        expectSound(nodes, 2.0);
        EXPECT_LT(offMiddle(nodes, joint), 0.5) << joint;
    }
}

TEST(BoltNodes, WithoutJointsAreCoarse) {
    const std::vector<double> nodes = boltNodes(2.0, std::nullopt, {}, dowel);
    expectSound(nodes, 2.0);
    EXPECT_EQ(nodes.size(), 61u);
}

}  // namespace
}  // namespace keyblock
