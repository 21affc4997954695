// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the nodes of a bolt are put, by hand and by the program.
#include "solver/engine/bolt/bolt_mesh.h"

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

/// A bar of 2 m with short elements at its joints alone.
MeshRequest jointsAt(std::vector<double> joints) {
    MeshRequest request;
    request.length = 2.0;
    request.longest = 0.1;
    for (const double joint : joints) request.fine.push_back({joint, dowel / 8.0, dowel});
    request.joints = std::move(joints);
    return request;
}

TEST(BoltNodes, GivenDivisionsAreEqual) {
    for (const int divisions : {1, 2, 59, 60, 1000}) {
        const std::vector<double> nodes = equalNodes(2.0, divisions);
        expectSound(nodes, 2.0);
        ASSERT_EQ(nodes.size(), static_cast<std::size_t>(divisions) + 1);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            EXPECT_NEAR(nodes[i], 2.0 * static_cast<double>(i) / divisions, 1e-15) << i;
    }
}

TEST(BoltNodes, AutomaticOnesAreFineAboutEveryJointAndGrowAwayFromIt) {
    const MeshRequest request = jointsAt({0.31, 0.9, 0.95, 1.7});
    const std::vector<double> nodes = gradedNodes(request);
    expectSound(nodes, 2.0);
    for (const double joint : request.joints) EXPECT_LT(offMiddle(nodes, joint), 1e-6) << joint;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
        const double element = nodes[i] - nodes[i - 1];
        EXPECT_LE(element, request.longest * (1.0 + 1e-9));
        for (const double joint : request.joints) {  // an element may grow by a fifth of its distance, and of its own length
            const double away = std::max(std::abs(nodes[i] - joint), std::abs(nodes[i - 1] - joint));
            EXPECT_LE(element, dowel / 8.0 + 0.2 * std::max(0.0, away - dowel) + 1e-9) << joint << " to " << nodes[i];
        }
    }
    EXPECT_LT(nodes.size(), 200u);
}

TEST(BoltNodes, AMirroredBoltHasTheMirroredNodes) {
    MeshRequest request = jointsAt({0.31, 0.9, 0.95, 1.7});
    request.nodes = {0.12, 1.2};
    request.fine.push_back({0.4, 0.03, 0.2});
    MeshRequest mirrored = request;
    mirrored.joints = {2.0 - 1.7, 2.0 - 0.95, 2.0 - 0.9, 2.0 - 0.31};
    mirrored.nodes = {0.8, 1.88};
    for (FinePlace& place : mirrored.fine) place.s = 2.0 - place.s;
    const std::vector<double> nodes = gradedNodes(request), others = gradedNodes(mirrored);
    ASSERT_EQ(nodes.size(), others.size());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        EXPECT_NEAR(nodes[i], 2.0 - others[nodes.size() - 1 - i], 1e-9) << i;
}

TEST(BoltNodes, APlaceThatIsAskedForIsANode) {
    MeshRequest request = jointsAt({1.0});
    request.nodes = {0.0, 0.1, 0.43, 1.23, 2.0};
    const std::vector<double> nodes = gradedNodes(request);
    expectSound(nodes, 2.0);
    for (const double place : request.nodes)
        EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(), [&](double s) { return std::abs(s - place) < 1e-12; }));
}

TEST(BoltNodes, JointsCloserThanAnElementKeepClearOfNodes) {
    for (const double apart : {0.1, 0.4, 0.5, 0.6, 0.9, 1.0, 1.1}) {
        const double second = 1.0 + apart * dowel / 8.0;
        const std::vector<double> nodes = gradedNodes(jointsAt({1.0, second}));
        expectSound(nodes, 2.0);
        for (const double joint : {1.0, second}) EXPECT_LT(offMiddle(nodes, joint), 0.45) << apart;
    }
}

TEST(BoltNodes, JointsNearTheEndsStayWithin) {
    for (const double joint : {1e-4, 1e-3, 0.01, 1.99, 1.9999}) {
        const std::vector<double> nodes = gradedNodes(jointsAt({joint}));
        expectSound(nodes, 2.0);
        EXPECT_LT(offMiddle(nodes, joint), 0.5) << joint;
    }
}

TEST(BoltNodes, WithoutJointsAreCoarse) { EXPECT_EQ(gradedNodes(jointsAt({})).size(), 21u); }

TEST(BoltNodes, AVeryLongBoltIsCoarserRatherThanWithoutEnd) {
    MeshRequest request;
    request.length = 1e3;
    request.longest = 50.0;
    request.fine = {{500.0, 0.01, 1e3}};
    const std::vector<double> nodes = gradedNodes(request);
    expectSound(nodes, 1e3);
    EXPECT_NEAR(static_cast<double>(nodes.size()), mostElements, 0.01 * mostElements);
}

}  // namespace
}  // namespace keyblock
