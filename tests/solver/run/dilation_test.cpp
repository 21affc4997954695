// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Joints that are driven apart against what holds them: the same as if the rock
// beside them were drawn away by as much.
#include "solver/run/run.h"

#include "solver/scene/preset.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

constexpr double opened = 0.5e-3;  // [m]

/// Two blocks of rigid rock and an elastic bolt across their joint.
Scene boltedBlocks() {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 84.78e6, std::nullopt, 0.0)};
    addBolt(scene, type, 0.05, 1.95, 19, PlateKind::Spring);
    scene.materials[0].second.density = 2700.0;
    return scene;
}

double boltForceAtJoint(const Frame& frame) { return frame.bolts[0].nodes[9].axialForce; }

/// What the bolt carries when the right block is drawn off by the same way.
double drawn() {
    Scene scene = boltedBlocks();
    scene.stages = {pullStage(scene, opened, 1)};
    return boltForceAtJoint(solve(scene).results.frames.back());
}

Dilation dilation(const Scene& scene, double rate) { return {scene.jointMaterials[0].first, rate}; }

TEST(Dilation, AStaticStageOpensTheJointAgainstTheBolt) {
    for (ContactMethod method : {ContactMethod::Penalty, ContactMethod::AugmentedLagrangian}) {
        Scene scene = boltedBlocks();
        scene.analysis.contact = method;
        Stage stage = test::settle(), rest = test::settle();
        stage.dilations = {dilation(scene, opened)};
        stage.increments = 4;
        rest.name = "rest";
        scene.stages = {stage, rest};
        const Solved solved = solve(scene);
        ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
        const double expected = drawn();
        ASSERT_GT(expected, 1e4);
        EXPECT_NEAR(boltForceAtJoint(solved.results.frames.back()), expected, 1e-4 * expected);
        EXPECT_NEAR(reading(solved, "last opening"), opened, 1e-4 * opened);
        const Energy& energy = solved.results.frames.back().energy;
        EXPECT_LT(std::abs(energy.balanceError), 1e-6);
        EXPECT_NEAR(energy.external, energy.bolt, 1e-3 * energy.bolt);  // the work of the joint is what the bolt stores
    }
}

TEST(Dilation, ADynamicStageOpensTheJointAtItsRate) {
    Scene scene = boltedBlocks();
    scene.materials[0].second.youngsModulus = 60e9;
    const double duration = 0.5;
    Stage stage = test::dynamic(duration, 1e-3);
    stage.dilations = {dilation(scene, opened / duration)};
    scene.stages = {stage};
    const Solved solved = solve(scene);
    const double expected = drawn();
    EXPECT_NEAR(boltForceAtJoint(solved.results.frames.back()), expected, 2e-2 * expected);
    EXPECT_LT(std::abs(solved.results.stages[0].health.balanceError), 1e-3);
}

/// Two stages open further than one; rates of different stages add up.
TEST(Dilation, WhatOneStageOpenedStaysForTheNext) {
    Scene scene = boltedBlocks();
    Stage first = test::settle(), second = test::settle();
    first.dilations = {dilation(scene, 0.4 * opened)};
    first.increments = 2;
    second = first;
    second.name = "more";
    second.dilations[0].rate = 0.6 * opened;
    scene.stages = {first, second};
    const Solved solved = solve(scene);
    EXPECT_NEAR(boltForceAtJoint(solved.results.frames.back()), drawn(), 1e-4 * drawn());
}

SceneJoint upright(const std::string& name, double x) {
    SceneJoint joint;
    joint.name = name;
    joint.points = {{x, 0.0}, {x, 1.0}};
    return joint;
}

constexpr double blockModulus = 10e9, blockLength = 2.0, wedge = 1e-5;  // [Pa, m, m]

/// A bar 2 m × 1 m of the domain, held at both ends, with joints across it; nothing goes aside.
Scene heldBar(const std::vector<SceneJoint>& joints) {
    Scene scene = emptyScene(blockModulus, 0.0, 30.0);
    scene.domain = SceneDomain{{{0, 0}, {blockLength, 0}, {blockLength, 1}, {0, 1}}, scene.materials.front().first, {}};
    scene.joints = joints;
    for (BoundarySide side : {BoundarySide::Left, BoundarySide::Right}) {
        Support support;
        support.boundary = side;
        support.fix = Fix::XY;
        scene.supports.push_back(support);
    }
    scene.stages = {test::settle()};
    return scene;
}

/// Force in the bar once a joint of it is driven apart by δ: δ over the give of rock, of two held ends and of joints,
/// each of two springs.
double forceOf(double delta, const Scene& scene, int joints) {
    const double spring = numericsOf(scene.analysis).penaltyRatio * blockModulus * scene.analysis.thickness;
    return delta / (blockLength / (blockModulus * scene.analysis.thickness) + (2.0 + joints) / (2.0 * spring));
}

/// What the contacts across x carry.
double forceAt(const Frame& frame, double x) {
    double force = 0.0;
    for (const ContactFrame& contact : frame.contacts)
        if (std::abs(contact.position.x() - x) < 0.01) force += contact.normalForce;
    return force;
}

TEST(Dilation, AJointOfADomainOpensByItsName) {
    Scene scene = heldBar({upright("fault", 1.0)});
    scene.stages[0].dilations = {{"fault", wedge}};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
    const double expected = forceOf(wedge, scene, 1);
    EXPECT_NEAR(forceAt(solved.results.frames.back(), 1.0), expected, 1e-4 * expected);
    EXPECT_NEAR(solved.results.frames.back().blocks[0].stress[0], -expected / scene.analysis.thickness,
                1e-4 * expected / scene.analysis.thickness);
    // strain is taken as small, so energies are as good as it is
    EXPECT_LT(std::abs(solved.results.frames.back().energy.balanceError), wedge / blockLength);
}

TEST(Dilation, AJointSetOpensByItsName) {
    Scene scene = heldBar({});
    SceneJointSet set;
    set.name = "steep", set.dip = 90.0, set.spacing = 5.0, set.origin = {1.0, 0.0};
    scene.jointSets = {set};
    scene.stages[0].dilations = {{"steep", wedge}};
    const double expected = forceOf(wedge, scene, 1);
    EXPECT_NEAR(forceAt(solve(scene).results.frames.back(), 1.0), expected, 1e-4 * expected);
}

/// Of two joints of one material, one opens by its name and both by that of the material; both together add up.
TEST(Dilation, TheNameOfAJointIsNotThatOfItsMaterial) {
    const std::vector<SceneJoint> joints{upright("first", 0.5), upright("second", 1.5)};
    const std::string material = heldBar({}).jointMaterials[0].first;
    const std::vector<std::pair<std::vector<Dilation>, double>> cases{
        {{{"first", wedge}}, 1.0},
        {{{material, wedge}}, 2.0},
        {{{"second", wedge}, {material, 0.5 * wedge}}, 2.0},
    };
    for (const auto& [dilations, times] : cases) {
        Scene scene = heldBar(joints);
        scene.stages[0].dilations = dilations;
        const Frame frame = solve(scene).results.frames.back();
        const double expected = forceOf(times * wedge, scene, 2);
        for (double x : {0.5, 1.5}) EXPECT_NEAR(forceAt(frame, x), expected, 1e-4 * expected) << dilations[0].joint;
    }
}

}  // namespace
}  // namespace keyblock
