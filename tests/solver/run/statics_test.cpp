// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Static stages through the whole run: what lets go, in which order and with
// which numbers, and what is reported of it.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using test::last;

constexpr double peak = 24.56e3, residual = 2.24e3, nodeBond = 84.78e6;  // per node

/// Twenty nodes of brittle bond across a joint in the middle of an element.
Scene shortRebar(bool restick, double displacement, int increments) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    Anchor anchor = anchorRange(Per::Node, AnchorLaw::PeakResidual, nodeBond, peak, residual);
    anchor.restick = restick;
    type.anchors = {anchor};
    addBolt(scene, type, 0.05, 1.95, 19, PlateKind::None);
    scene.stages = {pullStage(scene, displacement, increments)};
    return scene;
}

/// A linear bar held at both ends, its plate's or its anchor's strength given.
Scene endAnchored(const BoltType& bar, double displacement) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    addBolt(scene, bar, 0.0, 2.0, 20, bar.anchors.size() > 1 ? PlateKind::None : PlateKind::Spring);
    scene.stages = {pullStage(scene, displacement, 10)};
    return scene;
}

Load pointLoad(Point at, Point force) {
    Load load;
    load.blockAt = load.at = at;
    load.force = force;
    return load;
}

Solved solvedStages(const Scene& scene) {
    Solved solved = solve(scene);
    EXPECT_FALSE(solved.results.stages.empty());
    for (const StageResult& stage : solved.results.stages) {
        EXPECT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
        EXPECT_LT(std::abs(stage.health.balanceError), 1e-3);
    }
    return solved;
}

const Event* firstOf(const Solved& solved, EventKind kind) {
    for (const Event& event : solved.results.events)
        if (event.kind == kind) return &event;
    return nullptr;
}

std::vector<int> order(const Solved& solved) {
    std::vector<int> nodes;
    for (const Release& release : releases(solved)) nodes.push_back(release.index);
    return nodes;
}

TEST(Statics, HalvedIncrementsReleaseTheSame) {
    const Solved whole = solvedStages(shortRebar(false, 2e-3, 7));
    const Solved half = solvedStages(shortRebar(false, 2e-3, 14));
    ASSERT_GT(order(whole).size(), 5u);
    EXPECT_EQ(order(half), order(whole));
    const std::vector<Release> a = releases(whole), b = releases(half);
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        EXPECT_NEAR(b[i].load, a[i].load, 1e-3 * a[i].load) << i;
}

/// The whole displacement at once gives the same releases, for the way there is still followed.
TEST(Statics, AJumpAtTheStartReleasesTheSame) {
    const Solved steps = solvedStages(shortRebar(false, 2e-3, 10));
    Scene scene = shortRebar(false, 2e-3, 10);
    scene.stages[0].motions[0].table = {{0.0, 2e-3}};
    const Solved jump = solvedStages(scene);
    EXPECT_EQ(order(jump), order(steps));
    EXPECT_NEAR(reading(jump, "last joint force"), reading(steps, "last joint force"), 1e-6 * peak);
}

TEST(Statics, DebondingTellsTheForceJustBefore) {
    const Solved solved = solvedStages(shortRebar(false, 2e-3, 10));
    const Event* event = firstOf(solved, EventKind::Debonding);
    ASSERT_NE(event, nullptr);
    EXPECT_EQ(event->node, 9);  // a tie of both sides of the joint: the lower
    EXPECT_EQ(event->bolt, 0);
    EXPECT_EQ(event->element, -1);
    EXPECT_EQ(event->block, 0);
    EXPECT_NEAR(event->anchorForce, -peak, 1e-4 * peak);  // the fixed block pulls towards the far end
    EXPECT_NEAR(event->slip, -peak / nodeBond, 1e-4 * peak / nodeBond);
    EXPECT_NEAR(event->axialForce, releases(solved)[0].load, 1e-6 * peak);
    EXPECT_NEAR(event->position.x(), 0.95, 1e-3);
}

/// With sticking, a released point carries its residual against the slip and turns with it.
TEST(Statics, FrictionTurnsWithTheSlip) {
    Scene scene = shortRebar(true, 6e-3, 20);
    scene.stages[0].motions[0].table = {{0.0, 0.0}, {0.5, 6e-3}, {1.0, 0.0}};
    scene.stages[0].increments = 80;
    const Solved solved = solvedStages(scene);
    const BoltFrame& bolt = last(solved).bolts[0];
    int turned = 0;
    for (const BoltNodeFrame& node : bolt.nodes) {
        if (node.state != NodeState::Slipping) continue;
        EXPECT_LE(std::abs(node.anchorForce), residual * (1.0 + 1e-9));
        const double outward = node.block == 0 ? -1.0 : 1.0;  // sign while the joint opened
        turned += node.anchorForce * outward < -0.999 * residual;
    }
    EXPECT_GT(turned, 0);
}

/// Without sticking the force stays as it was at release.
TEST(Statics, KeptForceStaysWhenTheSlipTurns) {
    Scene scene = shortRebar(false, 3e-3, 20);
    scene.stages[0].motions[0].table = {{0.0, 0.0}, {0.5, 3e-3}, {1.0, 2e-3}};
    const Solved solved = solvedStages(scene);
    int kept = 0;
    for (const BoltNodeFrame& node : last(solved).bolts[0].nodes) {
        if (node.state != NodeState::Slipping) continue;
        EXPECT_NEAR(node.anchorForce, (node.block == 0 ? -1.0 : 1.0) * residual, 1e-9 * residual);
        ++kept;
    }
    EXPECT_GT(kept, 5);
}

TEST(Statics, TensileRuptureTellsItsElement) {
    BoltType bar = steelType(barArea(), {{0.0, 0.0}, {0.002, 400e6}, {0.02, 500e6}});
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e12), anchorAt(2.0, AnchorLaw::Elastic, 1e12)};
    const Solved solved = solvedStages(endAnchored(bar, 0.06));
    ASSERT_EQ(countOf(solved, EventKind::TensileRupture), 1);
    const Event* event = firstOf(solved, EventKind::TensileRupture);
    EXPECT_EQ(event->element, 0);
    EXPECT_EQ(event->node, -1);
    EXPECT_NEAR(event->axialForce, 500e6 * barArea(), 1e-3 * 500e6 * barArea());
    const Event* yield = firstOf(solved, EventKind::Yield);
    ASSERT_NE(yield, nullptr);
    EXPECT_NEAR(yield->axialForce, 400e6 * barArea(), 1e-3 * 400e6 * barArea());
    EXPECT_NEAR(reading(solved, "last joint force"), 0.0, 1e-3);
    EXPECT_TRUE(last(solved).bolts[0].nodes[0].ruptured);
}

/// On a flat piece of steel the elements of a bar share its stretch only as evenly as their forces balance.
TEST(Statics, AFlatPieceStretchesEvenlyAtAnyTolerance) {
    const Table flatAtLast{{0.0, 0.0}, {0.0024, 509e6}, {0.06, 585e6}, {0.16, 651e6}, {0.24, 651e6}};
    Scene scene = paperDBolt(flatAtLast, PlateKind::Spring, 60e9, 0.2, 70);
    const std::vector<Release> exact = releases(solve(scene));
    scene.analysis.tolerance = 1e-4;
    const std::vector<Release> usual = releases(solve(scene));
    ASSERT_FALSE(exact.empty());
    ASSERT_FALSE(usual.empty());
    EXPECT_NEAR(usual[0].opening, exact[0].opening, 5e-3 * exact[0].opening);
    EXPECT_NEAR(usual[0].load, exact[0].load, 1e-3 * exact[0].load);
}

TEST(Statics, PlateLossTellsThePlatesForce) {
    BoltType bar = linearType(barArea(), 200e9);
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e12)};
    bar.plate.normalStrength = 50e3;
    const Solved solved = solvedStages(endAnchored(bar, 4e-3));
    ASSERT_EQ(countOf(solved, EventKind::PlateLoss), 1);
    const Event* event = firstOf(solved, EventKind::PlateLoss);
    EXPECT_EQ(event->node, 20);
    EXPECT_EQ(event->block, 1);
    EXPECT_NEAR(std::abs(event->axialForce), 50e3, 5.0);
    EXPECT_FALSE(last(solved).bolts[0].plateHolds);
    EXPECT_NEAR(reading(solved, "last joint force"), 0.0, 1e-3);
}

TEST(Statics, AFailedShellLosesTheWholeBolt) {
    BoltType bar = linearType(barArea(), 200e9);
    Anchor shell = anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e9, 60e3, 40e3);
    shell.at = BoltPlace{false, 0.0};
    shell.onFailure = OnFailure::BoltLost;
    bar.anchors = {shell};
    const Solved solved = solvedStages(endAnchored(bar, 4e-3));
    ASSERT_EQ(countOf(solved, EventKind::BoltLoss), 1);
    EXPECT_EQ(countOf(solved, EventKind::Debonding), 1);
    EXPECT_NEAR(std::abs(firstOf(solved, EventKind::BoltLoss)->anchorForce), 60e3, 6.0);
    EXPECT_TRUE(last(solved).bolts[0].lost);
    for (const BoltNodeFrame& node : last(solved).bolts[0].nodes) {
        EXPECT_EQ(node.axialForce, 0.0);
        EXPECT_EQ(node.anchorForce, 0.0);
    }
}

/// Two blocks shear a stiffly held bar; it parts at 0.6 of its tensile force.
TEST(Statics, ShearRuptureTellsTheShear) {
    BoltType bar = steelType(barArea(), {{0.0, 0.0}, {0.00315, 630e6}, {0.16, 630.1e6}});
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9), anchorAt(0.1025, AnchorLaw::Elastic, 1e9)};
    bar.normalStiffness = 1e12;
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    addBolt(scene, bar, 0.94875, 1.05125, 41, PlateKind::None);
    scene.stages = {pullStage(scene, -2e-4, 4)};
    scene.stages[0].motions[0].axis = {0.0, 1.0};
    const Solved solved = solvedStages(scene);
    const Event* event = firstOf(solved, EventKind::ShearRupture);
    ASSERT_NE(event, nullptr);
    const double strength = 0.6 * 630.1e6 * barArea();
    EXPECT_NEAR(event->shearForce, -strength, 1e-4 * strength);  // the head's side is pushed to the right of the axis
    EXPECT_EQ(event->node, -1);
    EXPECT_EQ(event->element, 20);
}

TEST(Statics, MotionAlongASlantedAxisLeavesTheOtherFree) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.monitors.resize(1);
    scene.monitors[0].name = "centre";
    scene.monitors[0].point = Point(0.5, 0.5);
    Stage stage;
    stage.name = "push";
    stage.increments = 4;
    Motion motion;
    motion.blockAt = {0.5, 0.4};
    motion.axis = {3.0, 4.0};
    motion.table = {{0.0, 0.0}, {1.0, 0.5}};
    stage.motions = {motion};
    scene.stages = {stage};
    const Solved solved = solvedStages(scene);
    EXPECT_NEAR(reading(solved, "last centre.ux"), 0.3, 1e-12);
    EXPECT_NEAR(reading(solved, "last centre.uy"), 0.4, 1e-12);
}

/// A block on three point supports under pressure: uniform stress, and the height that goes with it.
TEST(Statics, PressureOnPointSupports) {
    Scene scene = emptyScene(10e9, 0.0, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {2, 1})};
    scene.analysis.penaltyRatio = 1e3;
    for (const auto& [x, fix] : {std::pair{0.0, Fix::XY}, {2.0, Fix::Y}}) {
        Support support;
        support.point = Point(x, 0.0);
        support.fix = fix;
        scene.supports.push_back(support);
    }
    scene.monitors.resize(1);
    scene.monitors[0].name = "top";
    scene.monitors[0].point = Point(1.0, 1.0);
    Stage stage;
    stage.name = "press";
    Load load;
    load.along = {Point(0.0, 1.0), Point(2.0, 1.0)};
    load.pressure = 1e6;
    stage.loads = {load};
    scene.stages = {stage};
    const Solved solved = solvedStages(scene);
    EXPECT_NEAR(last(solved).blocks[0].stress[1], -1e6, 1e-3);
    EXPECT_NEAR(last(solved).blocks[0].stress[0], 0.0, 1e-3);
    EXPECT_NEAR(last(solved).blocks[0].rotation, 0.0, 1e-12);
    const double supports = 1e6 * 2.0 / 2.0 / (1e3 * 10e9);  // half of the load on each spring
    EXPECT_NEAR(reading(solved, "last top.uy"), -1e6 / 10e9 - supports, 1e-3 * 1e-4);
}

Scene slidingSlope(double angle, double frictionAngle) {
    Scene scene = emptyScene(10e9, 0.2, frictionAngle);
    scene.blocks = {boxBlock("base", {-1, -1}, {9, 0}), boxBlock("slider", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(4.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {gravity * std::sin(angle * degree), -gravity * std::cos(angle * degree)};
    Stage stage;
    stage.name = "settle";
    scene.stages = {stage};
    return scene;
}

TEST(Statics, CollapseNamesTheMovingBlocks) {
    const Results results = runInMemory(slidingSlope(30.0, 25.0));
    ASSERT_EQ(results.stages.size(), 1u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Collapse);
    EXPECT_EQ(results.stages[0].blocks, std::vector<int>{1});
    EXPECT_NE(results.stages[0].message.find("slider"), std::string::npos);
    ASSERT_FALSE(results.events.empty());
    EXPECT_EQ(results.events.back().kind, EventKind::Collapse);
    EXPECT_EQ(results.events.back().block, 1);
}

TEST(Statics, ASlopeUnderItsFrictionAngleHolds) {
    const Solved solved = solve(slidingSlope(30.0, 31.0));
    EXPECT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    double shear = 0.0;
    for (const ContactFrame& c : last(solved).contacts) shear += std::abs(c.shearForce);
    EXPECT_NEAR(shear, 2700.0 * gravity * std::sin(30.0 * degree), 1e-4 * 2700.0 * gravity);
}

/// Cohesion holds a block on a slope that is too steep; under a larger load it fails once, at its strength.
TEST(Statics, CohesionFailsAtItsStrength) {
    Scene scene = slidingSlope(0.0, 30.0);
    scene.jointMaterials[0].second.cohesion = 20e3;
    scene.materials[0].second.poissonsRatio = 0.0;  // else the corners hold each other before they are pushed
    Stage& stage = scene.stages[0];
    Load load;
    load.blockAt = Point(0.5, 0.5);
    load.at = Point(0.5, 0.0);
    load.force = {60e3, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    stage.loads = {load};
    stage.increments = 10;
    const Results results = runInMemory(scene);
    const auto event = std::find_if(results.events.begin(), results.events.end(),
                                    [](const Event& e) { return e.kind == EventKind::JointSlip; });
    ASSERT_NE(event, results.events.end());
    const double strength = 20e3 + 2700.0 * gravity * std::tan(30.0 * degree);
    EXPECT_NEAR(event->time * 60e3, strength, 0.02 * strength);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Collapse);  // friction alone holds less
    EXPECT_EQ(results.stages[0].blocks, std::vector<int>{1});
}

TEST(Statics, LooseBlockIsNamed) {
    Scene scene = slidingSlope(0.0, 30.0);
    scene.materials[0].second.density = 0.0;
    scene.blocks[1] = boxBlock("floating", {3, 5}, {4, 6});
    Load load;
    load.blockAt = Point(3.5, 5.5);
    load.force = {1e3, 0.0};
    scene.stages[0].loads = {load};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages.size(), 1u);
    EXPECT_EQ(results.stages[0].outcome, Outcome::Failed);
    EXPECT_NE(results.stages[0].message.find("floating"), std::string::npos) << results.stages[0].message;
    EXPECT_EQ(results.stages[0].blocks, std::vector<int>{1});
}

/// A loose block falls while the bonds of a bolt beside it fail one at a time. The distance that it falls counts from the
/// equilibrium before, so the collapse is reported once it has moved by its size in all, not by its size for each bond.
TEST(Statics, AFallIsNotFollowedAgainForEachBondThatFails) {
    Scene scene = shortRebar(false, 0.0, 1);
    scene.materials[0].second.density = 2700.0;
    scene.materials[0].second.youngsModulus = 10e9;
    scene.blocks.push_back(boxBlock("loose", {4, 5}, {5, 6}));
    Stage& stage = scene.stages[0];
    stage.motions.clear();
    stage.loads = {pointLoad({1.5, 0.5}, {16.0 * peak, 0.0}), pointLoad({4.5, 5.5}, {0.0, -20e3})};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[0].outcome, Outcome::Collapse) << results.stages[0].message;
    EXPECT_EQ(results.stages[0].blocks, std::vector<int>{2});
    const auto debonded = std::count_if(results.events.begin(), results.events.end(),
                                        [](const Event& e) { return e.kind == EventKind::Debonding; });
    EXPECT_GE(debonded, 4);
    const double fallen = results.frames.back().blocks[2].displacement.norm();
    EXPECT_GE(fallen, 1.0);
    EXPECT_LE(fallen, 1.5);
}

/// A block without mass that only touches its base is held by it as soon as it is pressed.
TEST(Statics, AMasslessBlockRestsWherePressed) {
    Scene scene = slidingSlope(0.0, 30.0);
    scene.materials[0].second.density = 0.0;
    Load load;
    load.along = {Point(0.0, 1.0), Point(1.0, 1.0)};
    load.pressure = 1e5;
    scene.stages[0].loads = {load};
    const Solved solved = solvedStages(scene);
    EXPECT_NEAR(last(solved).blocks[1].stress[1], -1e5, 10.0);
}

/// What keeps drifting without end is named, however slowly it goes: here nothing holds the sheared block along x.
TEST(Statics, ASlowMechanismIsNamedWithoutAVerdict) {
    BoltType bar = linearType(barArea(), 200e9);
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9)};
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    addBolt(scene, bar, 0.95, 1.0525, 41, PlateKind::None);
    scene.stages = {pullStage(scene, -1e-4, 1)};
    scene.stages[0].motions[0].axis = {0.0, 1.0};
    scene.stages[0].until.maxSteps = 60;
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[0].outcome, Outcome::Undecided);
    EXPECT_EQ(results.stages[0].blocks, std::vector<int>{1});
    EXPECT_NE(results.stages[0].message.find("right"), std::string::npos);
}

}  // namespace
}  // namespace keyblock
