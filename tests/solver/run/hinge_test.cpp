// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plastic hinges, crushed rock and combined rupture in whole runs, against
// limit analysis. A hinge lies in the middle of an element, so spans between
// hinges are those of the nodes less half an element at each end.
#include "tests/solver/run/bolt_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double yieldStress = 500e6, steelModulus = 200e9;  // [Pa]
constexpr double gap = 0.2;  // [m]
const double plasticMoment = yieldStress * 0.02 * 0.02 * 0.02 / 6.0;  // of a full bar of 20 mm

BoltType plasticBar() {
    BoltType type = steelType(barArea(), {{0.0, 0.0}, {yieldStress / steelModulus, yieldStress}, {0.5, yieldStress}});
    type.normalStiffness = 1e10;
    return type;
}

/// What holds the blocks apart along the bolt: so weak that a bolt that turns is hardly pulled.
std::vector<Anchor> weakHold(double length) {
    return {anchorAt(0.0, AnchorLaw::Elastic, 1e6), anchorAt(length, AnchorLaw::Elastic, 1e6)};
}

Stage moveAcross(const Scene& scene, double displacement, int increments) {
    Stage stage = pullStage(scene, displacement, increments);
    stage.name = "across";
    stage.motions[0].axis = {0.0, 1.0};
    return stage;
}

Monitor shearMonitor(const Scene& scene) {
    Monitor shear = scene.monitors.back();
    shear.name = "shear force";
    shear.quantity = BoltQuantity::ShearForce;
    return shear;
}

/// Blocks on either side of a gap. The nodes at 1 m and at the other side are half a millimetre inside them, lest they
/// leave as the bolt bends.
Scene spannedGap() {
    constexpr double inside = 5e-4;
    Scene scene = gapBlocks(gap);
    for (Point& p : scene.blocks[0].points) p.x() += inside;
    for (Point& p : scene.blocks[1].points) p.x() -= inside;
    return scene;
}

/// Clamped at both faces of the gap, one of which moves across; `perGap` elements in the gap.
Scene swaying(int perGap) {
    Scene scene = spannedGap();
    BoltType type = plasticBar();
    type.anchors = weakHold(0.6);
    addBolt(scene, type, 0.8, 1.4, 3 * perGap, PlateKind::None);
    scene.monitors.push_back(shearMonitor(scene));
    scene.stages = {moveAcross(scene, 8e-3, 32)};
    return scene;
}

/// Half a wave of the same: only the head lies in the block that moves.
Scene cantilever(int perGap) {
    Scene scene = spannedGap();
    const double h = gap / perGap;
    for (Point& p : scene.blocks[1].points) p.x() -= 0.5 * h;
    BoltType type = plasticBar();
    type.anchors = weakHold(2.0 * gap);
    addBolt(scene, type, 0.8, 1.0 + gap, 2 * perGap, PlateKind::None);
    scene.monitors.push_back(shearMonitor(scene));
    scene.stages = {moveAcross(scene, 40e-3, 40)};
    return scene;
}

/// Clamped at both faces of the gap, pushed by a block that holds the middle node alone.
Scene pushedInTheMiddle(int perGap) {
    Scene scene = spannedGap();
    const double h = gap / perGap, middle = 1.0 + 0.5 * gap;
    Support support;
    support.blockAt = Point(1.5, 0.1);
    scene.supports.push_back(support);
    scene.blocks.push_back(boxBlock("tool", {middle - 0.3 * h, 0.3}, {middle + 0.3 * h, 0.7}));
    BoltType type = plasticBar();
    type.anchors = weakHold(0.6);
    type.anchors.push_back(anchorAt(0.3, AnchorLaw::Elastic, 1e6));
    addBolt(scene, type, 0.8, 1.4, 3 * perGap, PlateKind::None);
    scene.monitors.back().at = 0.2 + 0.25 * gap + 0.1 * h;
    scene.monitors.push_back(shearMonitor(scene));
    scene.stages = {moveAcross(scene, 4e-3, 32)};
    scene.stages[0].motions[0].blockAt = {middle, 0.35};
    return scene;
}

double largestShear(const Solved& solved) {
    return std::max(std::abs(reading(solved, "max shear force")), std::abs(reading(solved, "min shear force")));
}

// Hinges at both ends: Q·span = 2·M_p.
TEST(Hinges, ASwayingSpanCollapsesAtTwiceTheMomentOverTheSpan) {
    std::vector<double> off;
    for (const int perGap : {8, 16, 32}) {
        const Solved solved = solve(swaying(perGap));
        const double span = gap * (1.0 - 1.0 / perGap);
        EXPECT_NEAR(largestShear(solved) * span, 2.0 * plasticMoment, 5e-3 * plasticMoment) << perGap;
        EXPECT_EQ(countOf(solved, EventKind::Hinge), 2) << perGap;
        off.push_back(largestShear(solved) * gap / (2.0 * plasticMoment) - 1.0);
        const Energy& energy = solved.results.frames.back().energy;
        EXPECT_GT(energy.plastic, 0.0);
        EXPECT_NEAR(solved.results.frames.back().bolts[0].plasticEnergy, energy.plastic, 1e-9 * energy.plastic);
        EXPECT_LT(std::abs(energy.balanceError), 5e-3);
    }
    EXPECT_NEAR(off[0] / off[1], 2.0, 0.3);  // the error goes with the element
    EXPECT_NEAR(off[1] / off[2], 2.0, 0.3);
}

// One hinge at the face: P·span = M_p.
TEST(Hinges, ACantileverCollapsesAtItsMomentOverItsSpan) {
    for (const int perGap : {8, 16}) {
        const Solved solved = solve(cantilever(perGap));
        const double span = gap * (1.0 - 0.5 / perGap);
        const double yields = std::abs(reading(solved, "first hinge shear force"));
        EXPECT_NEAR(yields * span, plasticMoment, 5e-3 * plasticMoment) << perGap;
        EXPECT_EQ(countOf(solved, EventKind::Hinge), 1) << perGap;
    }
}

// Hinges at both faces and in the middle: P/2 · (half the span) = 2·M_p.
TEST(Hinges, ThreeOfThemMakeAMechanism) {
    for (const int perGap : {16, 32}) {
        const Solved solved = solve(pushedInTheMiddle(perGap));
        const double half = 0.5 * gap * (1.0 - 2.0 / perGap);
        EXPECT_NEAR(largestShear(solved) * half, 2.0 * plasticMoment, 0.02 * plasticMoment) << perGap;
        EXPECT_EQ(countOf(solved, EventKind::Hinge), 4) << perGap;  // two of them beside the middle
    }
}

/// The same sway under a pull of `share` of what yields the bar.
Scene pulledAndSwayed(double share) {
    Scene scene = swaying(16);
    Anchor hold = anchorRange(Per::Node, AnchorLaw::Elastic, 1e10, std::nullopt, 0.0);
    scene.boltTypes[0].anchors = {hold};
    Stage pull = loadStage(scene, share * yieldStress * barArea(), 4);
    Stage across = scene.stages[0];
    pull.motions = {across.motions[0]};
    pull.motions[0].table = {{0.0, 0.0}};
    scene.stages = {pull, across};
    return scene;
}

// In every element that has a hinge: |M| = M_p·[1 − (N/N_y)²] for the constant part of the moment, with N as it was
// when the last equilibrium began.
TEST(Hinges, AxialForceTakesItsPartOfTheMoment) {
    for (const double share : {0.0, 0.3, 0.6, 0.9}) {
        const Solved solved = solve(pulledAndSwayed(share));
        const std::vector<Frame>& frames = solved.results.frames;
        const std::vector<BoltNodeFrame>& nodes = frames.back().bolts[0].nodes;
        const std::vector<BoltNodeFrame>& before = frames[frames.size() - 2].bolts[0].nodes;
        int hinges = 0;
        for (const Event& event : solved.results.events) {
            if (event.kind != EventKind::Hinge) continue;
            ++hinges;
            const std::size_t e = event.element;
            const double constant = 0.5 * std::abs(nodes[e].moment + nodes[e + 1].moment);
            const double yieldForce = yieldStress * barArea();
            const double n = before[e].axialForce / yieldForce;
            EXPECT_NEAR(nodes[e].axialForce / yieldForce, share, 0.05) << share;
            EXPECT_NEAR(constant / plasticMoment, 1.0 - n * n, 1e-5) << share;
        }
        EXPECT_GE(hinges, 2) << share;
    }
}

TEST(Hinges, AStraightPullPastYieldMakesNone) {
    Scene scene = spannedGap();
    BoltType type = plasticBar();
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 1e10, std::nullopt, 0.0)};
    addBolt(scene, type, 0.8, 1.4, 24, PlateKind::None);
    scene.stages = {pullStage(scene, 10e-3, 10)};
    const Solved solved = solve(scene);
    EXPECT_GT(countOf(solved, EventKind::Yield), 0);
    EXPECT_EQ(countOf(solved, EventKind::Hinge), 0);
}

// Both sides of the joint: the rock gives p = strength × diameter to where the moment turns into a hinge, at
// x = Q/p from the joint, with M_p = Q·x/2; so Q = √(2·p·M_p).
TEST(Crushing, AShearedDowelReachesItsPlateau) {
    const double strength = 100e6, p = strength * 0.02;
    const double plateau = std::sqrt(2.0 * p * plasticMoment);
    std::vector<double> off;
    for (const double h : {4e-3, 2e-3}) {
        Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
        scene.analysis.tolerance = 1e-8;
        scene.jointMaterials[0].second.crushingStrength = strength;
        BoltType type = plasticBar();
        type.normalStiffness = 27.08e9;
        type.normalPer = Per::Length;
        const int elements = 2 * static_cast<int>(0.15 / h) + 1;
        type.anchors = weakHold(h * elements);
        addBolt(scene, type, 1.0 - 0.5 * h * elements, 1.0 + 0.5 * h * elements, elements, PlateKind::None);
        scene.monitors.push_back(shearMonitor(scene));
        scene.stages = {moveAcross(scene, 4e-3, 40)};
        const Solved solved = solve(scene);
        off.push_back(std::abs(reading(solved, "last shear force")) / plateau - 1.0);
        EXPECT_GE(countOf(solved, EventKind::Hinge), 2);
        EXPECT_LT(std::abs(solved.results.frames.back().energy.balanceError), 1e-2);
    }
    EXPECT_NEAR(off[1], 0.0, 0.05);
    EXPECT_LT(std::abs(off[1]), std::abs(off[0]) + 0.005);
}

/// A bar across a joint, pulled by `pull` [N] first, then sheared until it breaks.
Scene pulledThenSheared(double pull, RuptureRule rule) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = steelType(barArea(), {{0.0, 0.0}, {2.5e-3, 500e6}, {0.1, 600e6}});
    type.normalStiffness = 1e12;
    type.bending = Bending::Elastic;
    type.ruptureRule = rule;
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 1e10, std::nullopt, 0.0)};
    addBolt(scene, type, 1.0 - 0.2025, 1.0 + 0.2025, 81, PlateKind::None);
    scene.monitors.push_back(shearMonitor(scene));
    Stage load = loadStage(scene, pull, 4), across = moveAcross(scene, 2e-3, 40);
    load.motions = {across.motions[0]};
    load.motions[0].table = {{0.0, 0.0}};
    scene.stages = {load, across};
    return scene;
}

class CombinedRupture : public testing::TestWithParam<double> {};  // share of the tensile strength that pulls first

TEST_P(CombinedRupture, HappensOnTheCurveOfInteraction) {
    const double tension = 600e6 * barArea(), shear = 0.6 * tension;
    const Solved solved = solve(pulledThenSheared(GetParam() * tension, RuptureRule::Interaction));
    const auto broke = std::find_if(solved.results.events.begin(), solved.results.events.end(), [](const Event& e) {
        return e.kind == EventKind::ShearRupture || e.kind == EventKind::TensileRupture;
    });
    ASSERT_NE(broke, solved.results.events.end());
    const double n = broke->axialForce / tension, q = std::abs(broke->shearForce) / shear;
    EXPECT_NEAR(n * n + q * q, 1.0, 3e-4);
    EXPECT_EQ(broke->kind, n >= q ? EventKind::TensileRupture : EventKind::ShearRupture);
    EXPECT_NEAR(reading(solved, "max B.utilisation"), 1.0, 3e-4);
    EXPECT_GT(reading(solved, "max B.utilisation_with_moment"), 1.0);
}

INSTANTIATE_TEST_SUITE_P(Pulled, CombinedRupture, testing::Values(0.1, 0.4, 0.75));

TEST(IndependentRupture, LooksAtShearAlone) {
    const double tension = 600e6 * barArea();
    const Solved solved = solve(pulledThenSheared(0.4 * tension, RuptureRule::Independent));
    EXPECT_NEAR(std::abs(reading(solved, "first shear-rupture shear force")), 0.6 * tension, 1e-3 * tension);
    EXPECT_GT(reading(solved, "max B.utilisation"), 1.1);
}

}  // namespace
}  // namespace keyblock
