// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints through whole runs: stiffness of their own, friction that falls at the
// first slip, surfaces cut into pieces, faces that rebound, and contacts that
// end from one step to the next.
#include "solver/results/frame_quantities.h"
#include "solver/run/run.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace keyblock {
namespace {

using test::box;
using test::dynamic;
using test::expectDone;
using test::settle;
using test::weight;

/// A box `breadth` wide and 1 m high on a fixed base whose top runs from −1 to `end`; no gravity.
Scene boxOnLongBase(double breadth, double end, double modulus) {
    Scene scene = emptyScene(modulus, 0.2, 60.0);
    scene.blocks = {boxBlock("base", {-1, -1}, {end, 0}), boxBlock("box", {0, 0}, {breadth, 1})};
    Support support;
    support.blockAt = Point(-0.5, -0.5);
    scene.supports = {support};
    scene.output.frames = 10;
    return scene;
}

void press(Scene& scene, const Point& force, const Point& at) {
    Load load;
    load.blockAt = Point(0.1, 0.5);
    load.at = at;
    load.force = force;
    scene.stages.back().loads.push_back(load);
}

double contactSum(const Frame& frame, double ContactFrame::*member) {
    double sum = 0.0;
    for (const ContactFrame& c : frame.contacts) sum += c.*member;
    return sum;
}

/// A wedge that sinks into a notch by u = W/(2L·(kn·sin²α + ks·cos²α)). Its upper corners leave those of the rock on
/// the way, and what they carried along the faces must go over to the contacts that take their place.
TEST(JointStiffness, LetsAWedgeSinkIntoItsNotch) {
    const double height = 3.0, kn = 1e9;
    for (const double angle : {20.0, 45.0, 60.0})
        for (const double ratio : {1.0, 0.1}) {
            const double s = std::sin(angle * degree), c = std::cos(angle * degree), half = height * s / c;
            Scene scene = emptyScene(rigidRock, 0.0, 80.0);
            scene.analysis.gravity = {0.0, -gravity};
            scene.jointMaterials[0].second.normalStiffness = kn;
            scene.jointMaterials[0].second.shearStiffness = ratio * kn;
            for (const auto& [name, points] :
                 {std::pair{"left", std::vector<Point>{{-10, -5}, {0, -5}, {0, 0}, {-half, height}, {-10, height}}},
                  {"right", {{0, -5}, {10, -5}, {10, height}, {half, height}, {0, 0}}},
                  {"wedge", {{0, 0}, {half, height}, {-half, height}}}}) {
                scene.blocks.push_back(boxBlock(name, {0, 0}, {1, 1}));
                scene.blocks.back().points = points;
            }
            scene.supports.resize(2);
            scene.supports[0].blockAt = Point(-8.0, -2.0);
            scene.supports[1].blockAt = Point(8.0, -2.0);
            scene.stages = {settle()};
            const Results results = runInMemory(scene);
            expectDone(results, 1e-4);
            const double sinks = weight * height * half / (2.0 * height / c * kn * (s * s + ratio * c * c));
            EXPECT_NEAR(results.frames.back().blocks[2].displacement.y(), -sinks, 1e-4 * sinks) << angle << " " << ratio;
            Point push(0.0, 0.0);
            for (const ContactFrame& contact : results.frames.back().contacts) {
                EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-12);
                if (contact.blockA == 2) push += forceOnA(contact);
                if (contact.blockB == 2) push -= forceOnA(contact);
            }
            const double pull = weight * height * half;
            EXPECT_NEAR(push.y(), pull, 1e-4 * pull) << angle << " " << ratio;
            EXPECT_NEAR(push.x(), 0.0, 1e-4 * pull) << angle << " " << ratio;
        }
}

/// Closure σ/kn and shear τ/ks, whatever the penalty and the width.
TEST(JointStiffness, ClosesBySigmaOverKnAndShearsByTauOverKs) {
    for (const double breadth : {1.0, 0.4})
        for (const double penalty : {1.0, 40.0}) {
            Scene scene = boxOnLongBase(breadth, 3.0, rigidRock);
            scene.analysis.penaltyRatio = penalty;
            scene.jointMaterials[0].second.normalStiffness = 2e9;
            scene.jointMaterials[0].second.shearStiffness = 5e8;
            scene.stages = {settle()};
            press(scene, {3e4 * breadth, -1e6 * breadth}, {0.5 * breadth, 0.0});
            const Results results = runInMemory(scene);
            expectDone(results);
            EXPECT_NEAR(box(results).displacement.y(), -1e6 / 2e9, 1e-4 * 1e6 / 2e9);
            EXPECT_NEAR(box(results).displacement.x(), 3e4 / 5e8, 1e-3 * 3e4 / 5e8);
        }
}

/// Equal faces, whose corners meet, soft enough to lie well inside each other: in increments and in motion they are one
/// joint, not two.
TEST(JointStiffness, OfEqualFacesIsThatOfOneJoint) {
    const double closure = 1e-3;
    Scene scene = boxOnLongBase(1.0, 1.0, rigidRock);
    scene.blocks[0] = boxBlock("base", {0, -1}, {1, 0});
    scene.supports[0].blockAt = Point(0.5, -0.5);
    scene.jointMaterials[0].second.normalStiffness = 1e6 / closure;
    scene.stages = {settle(), dynamic(0.02, 1e-3)};
    scene.stages[0].increments = 100;
    press(scene, {0.0, -1e6}, {0.5, 0.0});
    std::swap(scene.stages[0].loads, scene.stages[1].loads);
    scene.stages[0].loads[0].table = {{0.0, 0.0}, {1.0, 1.0}};
    const Results results = runInMemory(scene);
    expectDone(results);
    for (const Frame& frame : results.frames) {
        const double loaded = frame.stage == 0 ? frame.time : 1.0;
        EXPECT_EQ(frame.contacts.size(), loaded > 0.0 ? 2u : 0u);
        EXPECT_NEAR(frame.blocks[1].displacement.y(), -closure * loaded, 1e-4 * closure);
    }
}

TEST(JointStiffness, ShearFollowsFromTheRatioWhereOnlyTheNormalOneIsGiven) {
    Scene scene = boxOnLongBase(1.0, 3.0, rigidRock);
    scene.jointMaterials[0].second.normalStiffness = 2e9;
    scene.analysis.shearRatio = 0.25;
    scene.stages = {settle()};
    press(scene, {3e4, -1e6}, {0.5, 0.0});
    EXPECT_NEAR(box(runInMemory(scene)).displacement.x(), 3e4 / 5e8, 1e-3 * 3e4 / 5e8);
}

/// Pushed 0.4 m out over the end of the base the box stands on 0.8 m, and closes the joint by so much more.
TEST(JointStiffness, FollowsTheLengthOnWhichFacesMeet) {
    Scene scene = boxOnLongBase(1.0, 1.2, rigidRock);
    scene.jointMaterials[0].second = JointMaterial{0.0, 0.0, 0.0, {}, 2e9, {}};
    Stage push = settle();
    push.increments = 40;
    Motion move;
    move.blockAt = {0.5, 0.5};
    move.table = {{0.0, 0.0}, {1.0, 0.4}};
    push.motions = {move};
    scene.stages = {settle(), push};
    press(scene, {0.0, -1e6}, {0.5, 0.5});
    std::swap(scene.stages[0].loads, scene.stages[1].loads);  // and stays
    const Results results = runInMemory(scene);
    for (const StageResult& stage : results.stages) EXPECT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
    EXPECT_NEAR(box(results).displacement.y(), -1e6 / (2e9 * 0.8), 1e-3 * 1e6 / 2e9);
    EXPECT_NEAR(contactSum(results.frames.back(), &ContactFrame::normalForce), 1e6, 1.0);
}

/// A corner without a face has no joint to give way: the penalty carries it.
TEST(JointStiffness, PointsKeepThePenalty) {
    Scene scene = boxOnLongBase(1.0, 3.0, rigidRock);
    scene.blocks[1].points = {{0, 0.5}, {0.5, 0}, {1, 0.5}, {0.5, 1}};
    scene.jointMaterials[0].second.normalStiffness = 1e6;
    scene.stages = {settle()};
    Load load;
    load.blockAt = Point(0.5, 0.5);
    load.force = {0.0, -1e6};
    scene.stages[0].loads = {load};
    EXPECT_NEAR(box(runInMemory(scene)).displacement.y(), 0.0, 1e-6);
}

/// Pushed along its joint, a box first carries tan 40° of its weight and, once it slips, tan 25°.
TEST(ResidualFriction, IsReachedAtTheFirstSlip) {
    Scene scene = boxOnLongBase(1.0, 3.0, 10e9);
    scene.analysis.gravity = {0.0, -gravity};
    scene.jointMaterials[0].second = JointMaterial{40.0, 0.0, 0.0, 25.0, {}, {}};
    Stage push = settle();
    push.increments = 20;
    Motion move;
    move.blockAt = {0.5, 0.5};
    move.table = {{0.0, 0.0}, {1.0, 2e-6}};
    push.motions = {move};
    scene.stages = {settle(), push};
    scene.output.frames = 100;
    const Results results = runInMemory(scene);
    expectDone(results, 1e-2);
    double most = 0.0;
    for (const Frame& frame : results.frames) most = std::max(most, std::abs(contactSum(frame, &ContactFrame::shearForce)));
    EXPECT_LE(most, weight * std::tan(40 * degree) * (1 + 1e-6));
    EXPECT_NEAR(std::abs(contactSum(results.frames.back(), &ContactFrame::shearForce)), weight * std::tan(25 * degree),
                1e-4 * weight);
    const auto slip = std::find_if(results.events.begin(), results.events.end(),
                                   [](const Event& e) { return e.kind == EventKind::JointSlip; });
    ASSERT_NE(slip, results.events.end());
    EXPECT_NEAR(std::abs(slip->shearForce), -slip->axialForce * std::tan(40 * degree), 1e-4 * weight);
    EXPECT_GT(results.frames.back().energy.released, 0.0);
}

/// On 30° a peak of 35° holds; a nudge takes it to 20°, and the box is gone.
TEST(ResidualFriction, LetsANudgedBoxGo) {
    Scene scene = boxOnLongBase(1.0, 9.0, 10e9);
    scene.analysis.gravity = {gravity * std::sin(30 * degree), -gravity * std::cos(30 * degree)};
    scene.jointMaterials[0].second = JointMaterial{35.0, 0.0, 0.0, 20.0, {}, {}};
    scene.stages = {dynamic(0.5, 1e-3)};
    EXPECT_LT(box(runInMemory(scene)).displacement.norm(), 1e-9);
    InitialVelocity nudge;
    nudge.blockAt = {0.5, 0.5};
    nudge.velocity = {0.1, 0.0};
    scene.stages[0].initialVelocities = {nudge};
    const Results results = runInMemory(scene);
    expectDone(results);
    const double a = gravity * (std::sin(30 * degree) - std::cos(30 * degree) * std::tan(20 * degree));
    EXPECT_NEAR(box(results).displacement.x(), 0.1 * 0.5 + 0.5 * a * 0.25, 0.01 * 0.5 * a * 0.25);
}

/// Base with its top from −1 to 9, in pieces that end at `cuts`.
Scene boxOnPieces(const std::vector<double>& cuts, bool ofOneBlock) {
    Scene scene = boxOnLongBase(1.0, 9.0, 10e9);
    scene.analysis.gravity = {gravity * std::sin(40 * degree), -gravity * std::cos(40 * degree)};
    scene.jointMaterials[0].second.frictionAngle = 20.0;
    if (ofOneBlock) {
        scene.blocks[0].points = {{-1, -1}, {9, -1}, {9, 0}};
        for (auto cut = cuts.rbegin(); cut != cuts.rend(); ++cut) scene.blocks[0].points.emplace_back(*cut, 0.0);
        scene.blocks[0].points.emplace_back(-1.0, 0.0);
    } else if (!cuts.empty()) {
        scene.blocks[0] = boxBlock("base", {-1, -1}, {cuts.front(), 0});
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const double end = i + 1 < cuts.size() ? cuts[i + 1] : 9.0;
            scene.blocks.push_back(boxBlock("", {cuts[i], -1}, {end, 0}));
            Support support;
            support.blockAt = Point(0.5 * (cuts[i] + end), -0.5);
            scene.supports.push_back(support);
        }
    }
    scene.stages = {dynamic(1.0, 1e-3)};
    scene.output.every = 1e-3;
    return scene;
}

std::vector<double> speeds(const Results& results) {
    std::vector<double> speed;
    for (const Frame& frame : results.frames) speed.push_back(frame.blocks[1].velocity.x());
    return speed;
}

/// A straight line of corners is one edge.
TEST(CutSurface, CollinearEdgesAreOne) {
    const std::vector<double> whole = speeds(runInMemory(boxOnPieces({}, true)));
    const std::vector<double> cut = speeds(runInMemory(boxOnPieces({1.1, 1.7, 2.3}, true)));
    ASSERT_EQ(whole.size(), cut.size());
    for (std::size_t i = 0; i < cut.size(); ++i) EXPECT_NEAR(cut[i], whole[i], 1e-9 * (1.0 + whole[i])) << i;
}

/// Neither do flush blocks side by side make friction jump.
TEST(CutSurface, FlushBlocksAreFeltAsOne) {
    const std::vector<double> whole = speeds(runInMemory(boxOnPieces({}, false)));
    const Results results = runInMemory(boxOnPieces({1.1, 1.7, 2.3}, false));
    expectDone(results);
    const std::vector<double> cut = speeds(results);
    ASSERT_EQ(whole.size(), cut.size());
    const double a = gravity * (std::sin(40 * degree) - std::cos(40 * degree) * std::tan(20 * degree));
    for (std::size_t i = 1; i < cut.size(); ++i) {
        EXPECT_NEAR(cut[i], whole[i], 1e-6 * (1.0 + whole[i])) << i;
        if (i > 1) {
            EXPECT_NEAR(cut[i] - cut[i - 1], a * 1e-3, 1e-4 * a * 1e-3) << i;
        }
    }
}

/// A face that lands flat rebounds flat: equal faces, one narrower than the other, and one shifted.
TEST(FlatImpact, ReboundsWithoutSpin) {
    for (const auto& [left, right] : {std::pair{0.0, 1.0}, {0.2, 0.9}, {0.0, 0.7}, {-0.3, 1.3}}) {
        Scene scene = emptyScene(10e9, 0.2, 0.0);
        scene.blocks = {boxBlock("below", {0, 0}, {1, 1}), boxBlock("above", {left, 1.0005}, {right, 2.0005})};
        scene.stages = {dynamic(0.01, 1e-4)};
        InitialVelocity fall;
        fall.blockAt = {0.5, 1.5};
        fall.velocity = {0.0, -1.0};
        scene.stages[0].initialVelocities = {fall};
        const bool centred = std::abs(left + right - 1.0) < 1e-12;
        const Results results = runInMemory(scene);
        expectDone(results, 1e-2);
        EXPECT_GT(box(results).velocity.y(), results.frames.back().blocks[0].velocity.y());
        if (centred) {
            EXPECT_NEAR(box(results).rotation, 0.0, 1e-11) << left;
        }
    }
}

/// A box thrown clear of its base in one step: the joint is reported as open.
TEST(JointEvents, AContactThatLeavesAtOnceOpens) {
    Scene scene = boxOnLongBase(1.0, 3.0, 10e9);
    scene.stages = {dynamic(0.05, 0.01)};
    InitialVelocity up;
    up.blockAt = {0.5, 0.5};
    up.velocity = {0.0, 50.0};
    scene.stages[0].initialVelocities = {up};
    const Results results = runInMemory(scene);
    EXPECT_EQ(std::count_if(results.events.begin(), results.events.end(),
                            [](const Event& e) { return e.kind == EventKind::JointOpen; }), 1);
}

/// Corners that meet in a point, and faces side by side that press on each other with round-off only.
TEST(JointEvents, ContactsWithoutForceNeitherDriftNorTell) {
    Scene scene = boxOnLongBase(1.0, 3.0, 10e9);
    scene.analysis.gravity = {0.0, -gravity};
    for (const auto& [x, y] : {std::pair{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}})
        scene.blocks.push_back(boxBlock("", {x, y}, {x + 1.0, y + 1.0}));
    scene.stages = {settle(), dynamic(2.0, 1e-3)};
    scene.stages[1].zeroDisplacements = true;
    const Results results = runInMemory(scene);
    expectDone(results);
    EXPECT_TRUE(std::none_of(results.events.begin(), results.events.end(), [](const Event& e) { return e.stage == 1; }));
    for (const BlockState& block : results.frames.back().blocks) EXPECT_LT(block.displacement.norm(), 1e-10);
}

}  // namespace
}  // namespace keyblock
