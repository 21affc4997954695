// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sizes, steps and shapes at the edge of sense: every run ends in a right
// answer or a plain outcome, with finite numbers and without energy from
// nowhere.
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace keyblock {
namespace {

using test::dynamic;
using test::settle;

constexpr double weight = 2700.0 * gravity;  // [N] of a cube of 1 m

/// A fixed slab, 1 m thick with its top at y = 0, under gravity.
Scene slab(double frictionAngle) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    scene.blocks = {boxBlock("slab", {-5, -1}, {10, 0})};
    Support support;
    support.blockAt = Point(0.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    scene.analysis.tolerance = 1e-4;
    scene.output.frames = 10;
    return scene;
}

Scene boxOnSlab(double frictionAngle) {
    Scene scene = slab(frictionAngle);
    scene.blocks.push_back(boxBlock("box", {0, 0}, {1, 1}));
    return scene;
}

Scene polygonOnSlab(std::vector<Point> points) {
    Scene scene = boxOnSlab(30.0);
    scene.blocks[1].points = std::move(points);
    return scene;
}

void expectFiniteResults(const Results& results) {
    for (const Frame& frame : results.frames) {
        for (const BlockState& block : frame.blocks) {
            EXPECT_TRUE(block.centroid.allFinite());
            EXPECT_TRUE(block.velocity.allFinite());
            for (const double s : block.stress) EXPECT_TRUE(std::isfinite(s));
        }
        for (const BoltFrame& bolt : frame.bolts)
            for (const BoltNodeFrame& node : bolt.nodes)
                EXPECT_TRUE(node.position.allFinite() && std::isfinite(node.axialForce + node.moment + node.slip));
        EXPECT_TRUE(std::isfinite(frame.energy.balanceError));
    }
    for (const HistoryRow& row : results.history)
        for (const double value : row.values) EXPECT_TRUE(std::isfinite(value));
}

void expectNoNewEnergy(const Results& results) {
    for (const Frame& frame : results.frames) {
        const Energy& e = frame.energy;
        const double given = std::abs(e.external) + e.kinetic + e.strain + e.contact;
        EXPECT_GE(e.damped + e.friction + e.plastic + e.released, -1e-6 * given - 1e-12) << frame.time;
    }
}

Results ran(const Scene& scene, Outcome outcome) {
    Results results = runInMemory(scene);
    EXPECT_EQ(results.stages.size(), scene.stages.size());
    for (const StageResult& stage : results.stages) EXPECT_EQ(stage.outcome, outcome) << stage.message;
    expectFiniteResults(results);
    expectNoNewEnergy(results);
    return results;
}

const BlockState& lastBlock(const Results& results) { return results.frames.back().blocks.back(); }

double supportForce(const Results& results) {
    double sum = 0.0;
    for (const ContactFrame& c : results.frames.back().contacts)
        if (std::min(c.blockA, c.blockB) == 0) sum += c.normalForce;
    return sum;
}

class TimeStep : public testing::TestWithParam<double> {};

TEST_P(TimeStep, RestStaysRest) {
    Scene scene = boxOnSlab(30.0);
    scene.stages = {dynamic(100 * GetParam(), GetParam())};
    EXPECT_LT(lastBlock(ran(scene, Outcome::Duration)).displacement.norm(), 1e-9);
}

TEST_P(TimeStep, AFallIsExact) {
    Scene scene = slab(30.0);
    scene.blocks.push_back(boxBlock("stone", {0, 1e6}, {1, 1e6 + 1}));
    scene.stages = {dynamic(100 * GetParam(), GetParam())};
    const double way = 0.5 * gravity * std::pow(100 * GetParam(), 2);
    EXPECT_NEAR(lastBlock(ran(scene, Outcome::Duration)).displacement.y(), -way, 1e-6 * way + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Extremes, TimeStep, testing::Values(1e-7, 1e-5, 1e-3, 0.03, 1.0));

class Penalty : public testing::TestWithParam<double> {};

TEST_P(Penalty, CarriesTheWeight) {
    Scene scene = boxOnSlab(30.0);
    scene.analysis.penaltyRatio = GetParam();
    scene.stages = {settle()};
    const Results results = ran(scene, Outcome::Equilibrium);
    EXPECT_NEAR(supportForce(results), weight, 1e-3 * weight);
    EXPECT_NEAR(lastBlock(results).displacement.y(), -0.5 * weight / (GetParam() * 10e9), 1e-2 * weight / 10e9 + 1e-6);
    scene.stages = {dynamic(0.05, 1e-3)};
    EXPECT_LT(lastBlock(ran(scene, Outcome::Duration)).displacement.norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Extremes, Penalty, testing::Values(1e-2, 1.0, 1e2, 1e4));

class Friction : public testing::TestWithParam<double> {};

TEST_P(Friction, SettlesOnTheLevel) {
    Scene scene = boxOnSlab(GetParam());
    scene.stages = {settle(), dynamic(0.05, 1e-3)};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 2u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Equilibrium);
    EXPECT_EQ(results.stages[1].outcome, Outcome::Duration);
    expectFiniteResults(results);
    EXPECT_NEAR(supportForce(results), weight, 1e-3 * weight);
}

INSTANTIATE_TEST_SUITE_P(Extremes, Friction, testing::Values(0.0, 1.0, 60.0, 89.0));

TEST(Extremes, SoftOnStiff) {
    for (const double softer : {1e2, 1e4, 1e8}) {
        Scene scene = boxOnSlab(30.0);
        scene.materials.push_back({"soft", {2700.0, 10e9, 0.2}});
        scene.materials[0].second.youngsModulus = 10e9 * softer;
        scene.blocks[1].material = "soft";
        scene.stages = {settle()};
        EXPECT_NEAR(supportForce(ran(scene, Outcome::Equilibrium)), weight, 1e-3 * weight) << softer;
    }
}

TEST(Extremes, PebbleUnderABlock) {
    Scene scene = slab(30.0);
    scene.blocks.push_back(boxBlock("pebble", {0, 0}, {1e-3, 1e-3}));
    scene.blocks.push_back(boxBlock("block", {-3, 1e-3}, {3, 6}));  // balanced on it, or down on one side
    scene.stages = {dynamic(0.05, 1e-4)};
    ran(scene, Outcome::Duration);
}

TEST(Extremes, TowerOfAHundred) {
    Scene scene = slab(30.0);
    for (int i = 0; i < 100; ++i) scene.blocks.push_back(boxBlock("", {0, i}, {1, i + 1.0}));
    scene.stages = {settle()};
    const Results results = ran(scene, Outcome::Equilibrium);
    EXPECT_NEAR(supportForce(results), 100 * weight, 1e-2 * weight);
    scene.stages = {dynamic(0.02, 1e-3)};
    EXPECT_LT(lastBlock(ran(scene, Outcome::Duration)).displacement.norm(), 1e-9);
}

TEST(Extremes, FourBlocksAtAPoint) {
    Scene scene = slab(30.0);
    for (const Point& low : {Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1)})
        scene.blocks.push_back(boxBlock("", low, low + Point(1, 1)));
    scene.stages = {settle()};
    const Results results = ran(scene, Outcome::Equilibrium);
    EXPECT_NEAR(supportForce(results), 4 * weight, 1e-3 * weight);
    for (std::size_t i = 1; i < 5; ++i) EXPECT_NEAR(results.frames.back().blocks[i].displacement.x(), 0.0, 1e-6);
}

TEST(Extremes, SliversSettle) {
    const double thin = std::tan(0.1 * std::acos(-1.0) / 180.0);
    for (const std::vector<Point>& sliver : {std::vector<Point>{{0, 0}, {1, 0}, {0, thin}},
                                             std::vector<Point>{{0, 0}, {1, 0}, {0.5, thin}}}) {
        Scene scene = polygonOnSlab(sliver);
        scene.stages = {settle()};
        EXPECT_NEAR(supportForce(ran(scene, Outcome::Equilibrium)), 0.5 * thin * weight, 1e-3 * thin * weight);
    }
}

/// A box in the corner of an L, a hair from its wall: the floor carries it.
TEST(Extremes, ConcaveBlockHoldsWhatLiesInIt) {
    Scene scene = boxOnSlab(30.0);
    scene.blocks[0].points = {{-1, -1}, {3, -1}, {3, 0}, {-0.001, 0}, {-0.001, 2}, {-1, 2}};
    scene.stages = {settle()};
    const Results results = ran(scene, Outcome::Equilibrium);
    EXPECT_NEAR(lastBlock(results).rotation, 0.0, 1e-7);
    EXPECT_NEAR(supportForce(results), weight, 1e-3 * weight);
}

TEST(Extremes, AKilometresFall) {
    Scene scene = slab(30.0);
    scene.blocks.push_back(boxBlock("stone", {0, 1000}, {1, 1001}));
    scene.stages = {dynamic(14.5, 0.01)};
    const Results results = ran(scene, Outcome::Duration);  // it lands after 14.28 s
    EXPECT_GT(lastBlock(results).centroid.y(), 0.0);
}

TEST(Extremes, AHundredMetresASecond) {
    Scene scene = slab(30.0);
    scene.blocks.push_back(boxBlock("stone", {0, 0.5}, {1, 1.5}));
    scene.stages = {dynamic(0.02, 1e-4)};
    scene.stages[0].initialVelocities.resize(1);
    scene.stages[0].initialVelocities[0].blockAt = {0.5, 1.0};
    scene.stages[0].initialVelocities[0].velocity = {0.0, -100.0};
    const Results results = ran(scene, Outcome::Duration);
    EXPECT_GT(lastBlock(results).centroid.y(), 0.0);
    EXPECT_LE(lastBlock(results).velocity.norm(), 101.0);
}

/// It turns by up to a tenth in a step, and straight ways of its corners would end in the rock.
TEST(Extremes, AStoneThatTumblesOntoTheFloorMakesNoEnergy) {
    for (const Integration scheme :
         {Integration::Shi, Integration::Newmark, Integration::GeneralizedAlpha, Integration::BackwardEuler})
        for (const double spin : {-40.0, -20.0, 0.0, 20.0}) {
            Scene scene = slab(35.0);
            scene.materials[0].second.youngsModulus = 50e9;
            scene.analysis.integration = scheme;
            Block stone = boxBlock("stone", {-0.06, -0.06}, {0.06, 0.06});
            for (Point& p : stone.points) p = Eigen::Rotation2Dd(0.35) * p + Point(0.0, 0.1);
            scene.blocks.push_back(stone);
            scene.stages = {dynamic(0.05, 2e-3)};
            scene.stages[0].initialVelocities = {{{0.0, 0.1}, {1.0, -9.0}, spin}};
            const Results results = runInMemory(scene);
            expectFiniteResults(results);
            EXPECT_EQ(results.stages[0].outcome, Outcome::Duration) << results.stages[0].message;
            EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-2) << spin;
        }
}

/// It turns about corners that stick, beside a block whose weight makes its own forces small. The arc of a corner is past
/// a limit of friction that no force came near.
TEST(Extremes, AStoneThatRollsMakesNoEnergy) {
    for (const Integration scheme :
         {Integration::Shi, Integration::Newmark, Integration::GeneralizedAlpha, Integration::BackwardEuler}) {
        Scene scene = slab(60.0);
        scene.materials[0].second.youngsModulus = 50e9;
        scene.analysis.integration = scheme;
        scene.blocks.push_back(boxBlock("heavy", {-4.9, 0}, {-0.9, 4}));
        Block stone = boxBlock("stone", {0, 0}, {1, 1});
        stone.points.clear();
        for (int i = 0; i < 8; ++i)
            stone.points.push_back(Eigen::Rotation2Dd((i + 0.5) * std::numbers::pi / 4.0) * Point(0.3, 0.0) +
                                   Point(0.0, 0.3 * std::cos(std::numbers::pi / 8.0)));
        scene.blocks.push_back(stone);
        scene.stages = {dynamic(1.0, 2e-3)};
        scene.stages[0].initialVelocities = {{{0.0, 0.2}, {1.5, 0.0}, -5.0}};
        const Results results = runInMemory(scene);
        expectFiniteResults(results);
        EXPECT_EQ(results.stages[0].outcome, Outcome::Duration) << results.stages[0].message;
        EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-2);
    }
}

/// A bar with friction along it between two blocks that are pulled 1 mm apart.
Scene pulled(const Point& farEnd, const Point& head, std::optional<int> divisions) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.analysis.tolerance = 1e-4;
    BoltType bar = linearType(barArea(), 200e9);
    bar.anchors = {anchorRange(Per::Length, AnchorLaw::Frictional, 2.5e9, 100e3, 0.0)};
    addBolt(scene, bar, 0.0, 2.0, 1, PlateKind::None);
    scene.bolts[0].farEnd = farEnd;
    scene.bolts[0].head = head;
    scene.bolts[0].divisions = divisions;
    scene.monitors.pop_back();
    scene.stages = {pullStage(scene, 1e-3, 10)};
    scene.output.frames = 5;
    return scene;
}

double largestAxial(const Results& results) {
    double largest = 0.0;
    for (const BoltNodeFrame& node : results.frames.back().bolts[0].nodes)
        largest = std::max(largest, std::abs(node.axialForce));
    return largest;
}

TEST(Extremes, BoltAlongAJoint) {
    const Results results = ran(pulled({1.0, 0.2}, {1.0, 0.8}, 10), Outcome::Equilibrium);
    EXPECT_LT(largestAxial(results), 1.0);  // in neither block: it holds nothing
}

TEST(Extremes, BoltThroughAVertex) {
    EXPECT_GT(largestAxial(ran(pulled({0.5, 0.5}, {1.5, 1.5}, std::nullopt), Outcome::Equilibrium)), 0.0);
    EXPECT_GT(largestAxial(ran(pulled({0.5, 1.0}, {1.5, 1e-3}, std::nullopt), Outcome::Equilibrium)), 0.0);
}

TEST(Extremes, BoltWithBothEndsFree) {
    EXPECT_GT(largestAxial(ran(pulled({-0.5, 0.5}, {2.5, 0.5}, 30), Outcome::Equilibrium)), 1e3);
}

TEST(Extremes, ThousandDivisions) {
    double axial[2];
    for (const int which : {0, 1}) {
        Scene scene = pulled({0.0, 0.5}, {2.0, 0.5}, which == 0 ? 99 : 999);
        scene.boltTypes[0].anchors = {anchorRange(Per::Length, AnchorLaw::Elastic, 2.5e9, std::nullopt, 0.0)};
        axial[which] = largestAxial(ran(scene, Outcome::Equilibrium));
    }
    EXPECT_NEAR(axial[1], axial[0], 0.01 * axial[0]);
}

TEST(Extremes, ElementsOfAMillimetreAcrossTheJoint) {
    EXPECT_GT(largestAxial(ran(pulled({0.95, 0.5}, {1.051, 0.5}, 101), Outcome::Equilibrium)), 100.0);
}

TEST(Extremes, BondsFromSoftToStiff) {
    for (const double stiffness : {1e4, 1e7, 1e10, 1e13}) {
        Scene scene = pulled({0.0, 0.5}, {2.0, 0.5}, 41);
        scene.boltTypes[0].anchors[0].stiffness = stiffness;
        const Results results = ran(scene, Outcome::Equilibrium);
        EXPECT_LE(largestAxial(results), 100e3 * (1.0 + 1e-6)) << stiffness;  // 1 m a side at 100 kN/m
    }
}

TEST(Extremes, AllBondsFailInOneStep) {
    Scene scene = pulled({0.025, 0.5}, {1.975, 0.5}, 39);
    scene.boltTypes[0].anchors = {anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e8, 10.0, 0.0)};
    scene.stages = {pullStage(scene, 0.05, 1)};
    const Results results = ran(scene, Outcome::Equilibrium);
    EXPECT_GT(results.events.size(), 15u);
    EXPECT_LT(largestAxial(results), 100.0);
}

TEST(Extremes, BoltDrawnRightOutInMotion) {
    Scene scene = pulled({0.6, 0.5}, {1.4, 0.5}, 16);
    scene.stages = {dynamic(0.2, 1e-3)};
    scene.stages[0].integration = Integration::BackwardEuler;  // under Shi's scheme a stiff bar rings on
    scene.stages[0].initialVelocities.resize(1);
    scene.stages[0].initialVelocities[0].blockAt = {1.5, 0.4};
    scene.stages[0].initialVelocities[0].velocity = {10.0, 0.0};
    const Results results = ran(scene, Outcome::Duration);
    EXPECT_GT(lastBlock(results).displacement.x(), 1.0);
    EXPECT_LT(largestAxial(results), 20e3);  // friction locks in at most half of its 100 kN/m on 0.4 m
}

}  // namespace
}  // namespace keyblock
