// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which corners are in front of which edges, once each, and what they keep from step to step.

#include "solver/engine/contact/joint.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/model/edge.h"
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace keyblock {
namespace {

struct Found {
    Model model;
    State state;
    std::vector<Contact> contacts;

    explicit Found(const Scene& scene, double margin = 1e-3) : model(makeModel(scene)), state(makeState(model)) {
        contacts = findContacts(model, state.blocks, {}, margin, true);
    }

    void shift(int block, const Point& by) {
        Vector6 d = Vector6::Zero();
        d.head<2>() = by;
        moveBlock(model.blocks[block], state.blocks[block], d);
    }

    int between(int a, int b) const {
        return static_cast<int>(std::count_if(contacts.begin(), contacts.end(), [&](const Contact& c) {
            return std::minmax(c.blockA, c.blockB) == std::minmax(a, b);
        }));
    }
};

Scene boxes(const std::vector<std::pair<Point, Point>>& corners) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    for (const auto& [low, high] : corners) scene.blocks.push_back(boxBlock("", low, high));
    return scene;
}

TEST(Contacts, StackedEqualBoxesHaveOneSpringPerCornerPair) {
    EXPECT_EQ(Found(boxes({{{0, 0}, {1, 1}}, {{0, 1}, {1, 2}}})).contacts.size(), 2u);
}

TEST(Contacts, ABrickOnTwoHasOneSpringPerCorner) {
    const Found found(boxes({{{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}, {{0.5, 1}, {1.5, 2}}}));
    EXPECT_EQ(found.between(0, 1), 2);
    EXPECT_EQ(found.between(0, 2), 2);
    EXPECT_EQ(found.between(1, 2), 2);
}

TEST(Contacts, FourBlocksAtAPoint) {
    const Found found(boxes({{{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}, {{0, 1}, {1, 2}}, {{1, 1}, {2, 2}}}));
    for (const auto& [a, b] : {std::pair{0, 1}, {0, 2}, {1, 3}, {2, 3}}) EXPECT_EQ(found.between(a, b), 2);
    EXPECT_LE(found.between(0, 3), 1);
    EXPECT_LE(found.between(1, 2), 1);
}

/// Bonds round the point hold the two that share no face, as long as they lead from one to the other.
TEST(Contacts, BondsHoldCornersThatMeetNoFace) {
    Scene scene = boxes({{{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}, {{0, 1}, {1, 2}}, {{1, 1}, {2, 2}}});
    scene.jointMaterials[0].second.cohesion = 1e6;
    Found found(scene);
    const auto across = [&] { return found.between(0, 3) + found.between(1, 2); };
    const auto breakAtPoint = [&](int a, int b) {
        for (Contact& c : found.contacts)
            if (std::minmax(c.blockA, c.blockB) == std::minmax(a, b) && (c.position - Point(1, 1)).norm() < 1e-9)
                c.bonded = false;
        found.contacts = findContacts(found.model, found.state.blocks, found.contacts, 1e-3, false);
    };
    EXPECT_EQ(found.contacts.size(), 8u);
    EXPECT_EQ(across(), 0);
    breakAtPoint(0, 1);
    EXPECT_EQ(across(), 0);
    breakAtPoint(2, 3);
    EXPECT_EQ(found.between(0, 3), 1);  // 0 and 2 hold together, and 1 and 3
    EXPECT_EQ(found.between(1, 2), 1);
    EXPECT_EQ(found.contacts.size(), 10u);
}

TEST(Contacts, LengthsOfAJointAddUpToIt) {
    Scene scene = boxes({{{0, 0}, {3, 1}}, {{1, 1}, {2, 2}}, {{2.5, 1}, {4.5, 2}}});
    scene.jointMaterials[0].second.cohesion = 1e6;
    const Found found(scene);
    std::map<std::pair<int, int>, double> length;
    for (const Contact& c : found.contacts) length[std::minmax(c.blockA, c.blockB)] += c.length;
    EXPECT_NEAR((length[{0, 1}]), 1.0, 1e-12);
    EXPECT_NEAR((length[{0, 2}]), 0.5, 1e-12);
    for (const Contact& c : found.contacts) EXPECT_TRUE(c.bonded);
}

TEST(Contacts, FacesThatTouchCarryNothingAtFirst) {
    Scene scene = boxes({{{0, 0}, {1, 1}}, {{0.25, 1}, {1.25, 2}}});
    for (Block& block : scene.blocks)
        for (Point& p : block.points)  // where round-off opens or closes the joint
            p = Eigen::Rotation2D<double>(0.3) * p + Point(1e5, -1e5);
    const Found found(scene);
    ASSERT_EQ(found.contacts.size(), 2u);
    StepProblem problem;
    problem.blocks = 2;
    State state = found.state;
    state.contacts = found.contacts;
    addContactLinks(found.model, state, false, problem);
    for (const Link& link : problem.links)
        EXPECT_NEAR(respond(link.law, link.strain).force, 0.0, 1e-15 * link.law.stiffness);
}

TEST(Contacts, OpenFacesGiveNoOffset) {
    const Found found(boxes({{{0, 0}, {1, 1}}, {{0.25, 1.0001}, {1.25, 2}}}));
    ASSERT_EQ(found.contacts.size(), 2u);
    for (const Contact& c : found.contacts) {
        EXPECT_EQ(c.gapOffset, 0.0);
        EXPECT_NEAR(c.gap, 1e-4, 1e-12);
    }
}

TEST(Contacts, HistoryFollowsTheFeatures) {
    Found found(boxes({{{0, 0}, {4, 1}}, {{0, 1}, {1, 2}}, {{1.0005, 1}, {2, 2}}, {{3, 1}, {4, 2}}}));
    const auto key = [](const Contact& c) { return std::tuple(c.blockA, c.corner, c.blockB, c.edge); };
    double mark = 0.0;
    std::map<std::tuple<int, int, int, int>, double> marks;
    for (Contact& c : found.contacts) marks[key(c)] = c.slipOffset = mark += 1e-6;
    found.shift(2, {0.5, 0.0});  // away from one neighbour
    std::vector<Contact> now = findContacts(found.model, found.state.blocks, found.contacts, 1e-3, false);
    EXPECT_NE(now.size(), found.contacts.size());
    for (const Contact& c : now) {
        ASSERT_TRUE(marks.contains(key(c)));
        EXPECT_EQ(c.slipOffset, marks[key(c)]);
    }
}

TEST(Contacts, CornersThatPassEachOtherMeetOnce) {
    Found found(boxes({{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}}));  // touch in a corner only
    EXPECT_LE(found.contacts.size(), 1u);
    found.shift(1, {-1e-6, -2e-6});
    EXPECT_LE(findContacts(found.model, found.state.blocks, found.contacts, 1e-3, false).size(), 1u);
}

/// An L holds a box on its floor and at its wall: the corner in the notch stands before both.
TEST(Contacts, CornerInANotchStandsBeforeBothSides) {
    Scene scene = boxes({{{0, 0}, {1, 1}}, {{0.0001, 0}, {1, 1}}});
    scene.blocks[0].points = {{-1, -1}, {2, -1}, {2, 0}, {0, 0}, {0, 2}, {-1, 2}};
    const Found found(scene);
    int floor = 0, wall = 0;
    for (const Contact& c : found.contacts) {
        if (c.blockA != 1 || c.blockB != 0) continue;
        const Edge edge = edgeOf(found.state.blocks[0].corners, c.edge);
        floor += edge.outward.y() > 0.9;
        wall += edge.outward.x() > 0.9;
    }
    EXPECT_EQ(floor, 2);
    EXPECT_EQ(wall, 2);
}

/// Just inside a convex corner, only the nearer face is the way in.
TEST(Contacts, CornerInsideAConvexCornerTakesTheNearerFace) {
    Found found(boxes({{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}}));
    found.shift(1, {-1e-5, -3e-5});
    for (const Contact& c : findContacts(found.model, found.state.blocks, {}, 1e-3, false)) {
        const Edge edge = edgeOf(found.state.blocks[c.blockB].corners, c.edge);
        EXPECT_NEAR(std::abs(edge.outward.x()), 1.0, 1e-12);
        EXPECT_NEAR(c.gap, -1e-5, 1e-12);
    }
}

/// Displacement of the second of two blocks.
Eigen::VectorXd pathOf(const Point& by) {
    Eigen::VectorXd path = Eigen::VectorXd::Zero(12);
    path.segment<2>(6) = by;
    return path;
}

/// Outward normal of the one edge of block 0 that corner 0 of block 1 comes in by; zero where it is not one.
Point entranceOf(const Found& found, const std::vector<Contact>& contacts) {
    Point normal(0.0, 0.0);
    for (const Contact& c : contacts) {
        if (c.blockA != 1 || c.corner != 0) continue;
        if (normal.norm() > 0.0) return {0.0, 0.0};
        normal = edgeOf(found.state.blocks[0].corners, c.edge).outward;
    }
    return normal;
}

/// Beside a corner the path says which face is met first; the nearer one now would be the wrong one.
TEST(Contacts, ACornerComesInWhereItsPathCrossesTheOutline) {
    const Found found(boxes({{{0, 0}, {1, 1}}, {{1.1, 1.05}, {2.1, 2.05}}}));
    const Eigen::VectorXd over = pathOf({-0.3, -0.1}), beside = pathOf({-0.15, -0.3});
    for (const auto& [path, normal] : {std::pair(&over, Point(0, 1)), std::pair(&beside, Point(1, 0))}) {
        FoundCorners corners;
        const std::vector<Contact> contacts = findContacts(found.model, found.state.blocks, {},
                                                           {0.5, false, false, path, nullptr, &corners});
        EXPECT_LT((entranceOf(found, contacts) - normal).norm(), 1e-12);
        EXPECT_TRUE(entrancesHold(found.model, found.state.blocks, contacts, corners, *path));
        const Eigen::VectorXd& other = path == &over ? beside : over;
        EXPECT_FALSE(entrancesHold(found.model, found.state.blocks, contacts, corners, other));
        EXPECT_FALSE(entrancesHold(found.model, found.state.blocks, contacts, corners, other, 0.01));
        EXPECT_TRUE(entrancesHold(found.model, found.state.blocks, contacts, corners, other, 0.5));
    }
}

/// The contacts that close on the path, as block, corner, block and edge.
std::set<std::array<int, 4>> closing(const Found& found, const std::vector<Contact>& contacts,
                                     const Eigen::VectorXd& path) {
    std::set<std::array<int, 4>> result;
    for (const Contact& c : contacts) {
        const Edge edge = edgeOf(found.state.blocks[c.blockB].corners, c.edge);
        const Point corner = found.state.blocks[c.blockA].corners[c.corner], from = corner - edge.start;
        const auto moved = [&](int block) {
            const Point arm = turnLeft(corner - found.state.blocks[block].centroid);
            return Point(path.segment<2>(6 * block) + path[6 * block + 2] * arm);
        };
        if (edge.outward.dot(from + moved(c.blockA) - moved(c.blockB)) < c.gapOffset - found.model.tolerance)
            result.insert({c.blockA, c.corner, c.blockB, c.edge});
    }
    return result;
}

/// Two boxes that touch or overlap slightly at a corner, or are a little apart there, with forces in some contacts.
/// Another path, a little or quite different, is accepted exactly if a search for it finds the same closing contacts.
TEST(Contacts, AnotherPathIsAcceptedIfASearchForItFindsTheSame) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const auto some = [&](double size) {
        Eigen::VectorXd path = pathOf({size * any(random), size * any(random)});
        path[8] = any(random) > 0.0 ? size * any(random) : 0.0;
        return path;
    };
    int held = 0, refused = 0;
    for (int n = 0; n < 8000; ++n) {
        const double scale = std::pow(10.0, -3.5 + 1.5 * any(random));
        const Point corner = Point(1.0, 1.0) + some(scale).segment<2>(6);
        Found found(boxes({{{0, 0}, {1, 1}}, {corner, corner + Point(1.0, 1.0)}}));
        for (Contact& c : found.contacts) c.normalForce = std::max(0.0, any(random));
        const Eigen::VectorXd path = some(scale), other = path + some(scale * std::pow(10.0, 2.0 * any(random)));
        const double margin = 8.0 * std::max(scale, other.norm());
        const auto search = [&](const std::vector<Contact>& before, const Eigen::VectorXd& on, bool estimated,
                                FoundCorners* corners) {
            return findContacts(found.model, found.state.blocks, before,
                                {margin, false, false, &on, nullptr, corners, estimated});
        };
        FoundCorners corners;
        const std::vector<Contact> contacts = search(found.contacts, path, any(random) > 0.0, &corners);
        const std::vector<Contact> again = search(contacts, other, false, nullptr);
        const bool same = closing(found, contacts, other) == closing(found, again, other);
        EXPECT_EQ(entrancesHold(found.model, found.state.blocks, contacts, corners, other), same) << n;
        ++(same ? held : refused);
    }
    EXPECT_GT(held, 500);
    EXPECT_GT(refused, 500);
}

/// Direction in which block 0 pushes block 1 in all contacts between them; zero if they differ or there are none.
Point pushOf(const Found& found, const std::vector<Contact>& contacts) {
    Point push(0.0, 0.0);
    for (const Contact& c : contacts) {
        const Point normal = edgeOf(found.state.blocks[c.blockB].corners, c.edge).outward;
        const Point now = c.blockA == 1 ? normal : Point(-normal);
        if (push.norm() > 0.0 && (push - now).norm() > 1e-12) return {0.0, 0.0};
        push = now;
    }
    return push;
}

/// Directly at a corner, an estimated path says little; it decides only once the corners are farther apart.
TEST(Contacts, AnEstimatedPathDoesNotChangeTheEdgeOfACornerAtACorner) {
    const Eigen::VectorXd over = pathOf({-0.3, -0.1}), beside = pathOf({-0.1, -0.3});
    for (const auto& [apart, kept] : {std::pair(1e-7, true), std::pair(1e-3, false)}) {
        const Found found(boxes({{{0, 0}, {1, 1}}, {{1 + apart, 1 + apart}, {2, 2}}}));
        const auto search = [&](const Eigen::VectorXd& path, const std::vector<Contact>& before, bool estimated) {
            return pushOf(found, findContacts(found.model, found.state.blocks, before,
                                              {0.5, false, false, &path, nullptr, nullptr, estimated}));
        };
        const std::vector<Contact> last = findContacts(found.model, found.state.blocks, {},
                                                       {0.5, false, false, &over, nullptr});
        ASSERT_LT((pushOf(found, last) - Point(0, 1)).norm(), 1e-12);
        EXPECT_LT((search(beside, last, true) - (kept ? Point(0, 1) : Point(1, 0))).norm(), 1e-12);
        EXPECT_LT((search(beside, last, false) - Point(1, 0)).norm(), 1e-12);
    }
}

/// Both lines ahead, and the one that is crossed last is not the one that it is least behind in the end.
TEST(Contacts, TheLastLineCrossedIsTheOutline) {
    const Found found(boxes({{{0, 0}, {1, 1}}, {{1.01, 1.1}, {2.01, 2.1}}}));
    const Eigen::VectorXd path = pathOf({-0.06, -0.2});  // over the right side's line at y 1.067, down by the top
    const std::vector<Contact> contacts =
        findContacts(found.model, found.state.blocks, {}, {0.5, false, false, &path, nullptr});
    EXPECT_LT((entranceOf(found, contacts) - Point(0, 1)).norm(), 1e-12);
}

TEST(Contacts, CornersInAStraightLineAreNone) {
    Scene scene = boxes({{{0, 0}, {3, 1}}, {{0.5, 1}, {1.5, 2}}});
    scene.blocks[0].points = {{0, 0}, {3, 0}, {3, 1}, {1.2, 1}, {1, 1}, {0, 1}};
    scene.blocks[1].points.insert(scene.blocks[1].points.begin() + 1, Point(0.8, 1.0));
    scene.jointMaterials[0].second.cohesion = 1e6;
    const Found found(scene);
    ASSERT_EQ(found.contacts.size(), 2u);
    for (const Contact& c : found.contacts) EXPECT_NEAR(c.length, 0.5, 1e-12);
}

/// A corner presses on a wedge close to its tip, where the wedge is thinner than the corner is deep.
TEST(Contacts, ACornerPressedIntoTheTipOfAWedgeKeepsItsContact) {
    Scene scene = boxes({{{0, -1}, {1 - 5e-5, 0}}, {{0, 0}, {1, 1}}});
    scene.blocks[1].points = {{0, 0}, {1, 0}, {0, 0.1}};
    Found found(scene);
    const auto atTip = [](const std::vector<Contact>& contacts) {
        return std::count_if(contacts.begin(), contacts.end(),
                             [](const Contact& c) { return c.blockA == 0 && c.position.x() > 0.9; });
    };
    ASSERT_EQ(atTip(found.contacts), 1);
    found.shift(1, {0.0, -1e-5});
    EXPECT_EQ(atTip(findContacts(found.model, found.state.blocks, found.contacts, 1e-3, false)), 1);
    EXPECT_EQ(atTip(findContacts(found.model, found.state.blocks, {}, 1e-3, false)), 0);  // it could be above the wedge
    found.shift(1, {0.0, -0.01});
    EXPECT_EQ(atTip(findContacts(found.model, found.state.blocks, found.contacts, 1e-3, false)), 0);  // it has passed
}

/// A corner on the boundary of a block, at a face that it does not stand on, is not deep behind another face.
TEST(Contacts, ACornerOnTheBoundaryIsNotBehindAnotherFace) {
    Scene scene = boxes({{{0, 0}, {1, 1}}, {{1, 0}, {2, 1}}});
    scene.blocks[0].points = {{0, 1}, {1, -0.7}, {1.04, 0.5}, {0.04, 1}};
    scene.blocks[1].points = {{0.042, 0.999}, {-0.258, 1.199}, {-0.258, 0.999}};
    const Found found(scene);
    const auto atCorner = [](const Contact& c) { return c.blockA == 1 && c.corner == 0; };
    EXPECT_TRUE(std::none_of(found.contacts.begin(), found.contacts.end(), atCorner));
}

/// A box slides over the end of its base: where its corner stood, the base's corner takes over, force for force.
/// \param apart the distance of the faces, which a contact bridges that has carried its force over from another one.
void expectRolesToChange(double apart) {
    Found found(boxes({{{0, 0}, {2, 1}}, {{0.9, 1}, {1.9, 2}}}));
    for (Contact& c : found.contacts) {
        if (c.corner != 1) continue;
        addForces(found.model, c, {100.0, 20.0});
        c.gapOffset += apart;
        c.normalForce = 100.0;
        c.shearForce = 20.0;
        c.limit = 50.0;
    }
    found.shift(1, {0.1001, apart});
    double lost = 0.0;
    State state = found.state;
    state.contacts = findContacts(found.model, state.blocks, found.contacts, {1e-3, false, false, nullptr, &lost});
    const auto heir = std::find_if(state.contacts.begin(), state.contacts.end(),
                                   [](const Contact& c) { return c.blockA == 0 && c.blockB == 1; });
    ASSERT_NE(heir, state.contacts.end());
    EXPECT_NEAR(heir->normalForce, 100.0, 1e-9);
    EXPECT_NEAR(heir->shearForce, 20.0, 1e-9);
    StepProblem problem;
    problem.blocks = 2;
    addContactLinks(found.model, state, false, problem);
    Point onBox(0.0, 0.0);
    for (const Link& link : problem.links)
        onBox -= respond(link.law, link.strain).force * (link.a == 1 ? link.ga : link.gb).head<2>();
    EXPECT_NEAR(onBox.x(), 20.0, 1e-3);
    EXPECT_NEAR(onBox.y(), 100.0, 1e-3);
}

TEST(Contacts, RolesChangeAtTheEndOfAnEdge) {
    expectRolesToChange(0.0);
    expectRolesToChange(5e-6);
}

}  // namespace
}  // namespace keyblock
