// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts that come and go at the start of a stage.
#include "solver/run/run.h"

#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using test::lastOf;
using test::settle;

constexpr double boltForce = 100e3;  // [N]

/// Two blocks with an elastic bolt of 19 elements across their joint, no stage yet.
Scene bolted(PlateKind plate, double pretension = 0.0) {
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 84.78e6, std::nullopt, 0.0)};
    addBolt(scene, type, 0.05, 1.95, 19, plate);
    scene.bolts[0].pretension = pretension;
    return scene;
}

Stage pulledTo(const Scene& scene, const std::string& name, double displacement) {
    Stage stage = pullStage(scene, displacement, 1);
    stage.name = name;
    return stage;
}

double forceInJoint(const Frame& frame) { return frame.bolts[0].nodes.empty() ? 0.0 : frame.bolts[0].nodes[9].axialForce; }

/// A bolt installed across a joint that has opened feels what it opens from then on.
TEST(Installation, ABoltFeelsOnlyWhatComesAfterIt) {
    const double opened = 1e-3, more = 0.5e-3;
    Scene early = bolted(PlateKind::Spring);
    early.stages = {pulledTo(early, "pull", more)};
    Scene late = bolted(PlateKind::Spring);
    Stage install = settle();
    install.name = "install";
    install.install = {late.bolts[0].name};
    late.stages = {pulledTo(late, "open", opened), install, pulledTo(late, "pull", opened + more)};
    const Solved a = solve(early), b = solve(late);
    EXPECT_TRUE(lastOf(b, 0).bolts[0].nodes.empty());
    ASSERT_FALSE(lastOf(b, 1).bolts[0].nodes.empty());
    EXPECT_NEAR(forceInJoint(lastOf(b, 1)), 0.0, 1e-3);
    EXPECT_NEAR(lastOf(b, 1).bolts[0].nodes.back().position.x(), 1.95 + opened, 1e-9);
    const double expected = forceInJoint(a.results.frames.back());
    ASSERT_GT(expected, 10e3);
    EXPECT_NEAR(forceInJoint(b.results.frames.back()), expected, 1e-6 * expected);
    EXPECT_LT(std::abs(b.results.stages[2].health.balanceError), 1e-6);
}

/// In rock that has moved and turned it is straight and unstressed.
TEST(Installation, ABoltInTurnedRockIsUnstressed) {
    Scene scene = bolted(PlateKind::None);
    scene.supports.clear();
    scene.blocks = {boxBlock("rock", {0, 0}, {2, 1})};
    scene.monitors.clear();
    Stage spin = test::dynamic(0.1, 1e-3);
    spin.initialVelocities = {{Point(0.9, 0.4), Point(0.0, 0.0), 2.0}};
    Stage install = test::dynamic(0.05, 1e-3);
    install.name = "install";
    install.install = {scene.bolts[0].name};
    scene.stages = {spin, install};
    const Solved solved = solve(scene);
    const Frame& frame = solved.results.frames.back();
    ASSERT_FALSE(frame.bolts[0].nodes.empty());
    const Point along = frame.bolts[0].nodes.back().position - frame.bolts[0].nodes.front().position;
    EXPECT_NEAR(std::atan2(along.y(), along.x()), frame.blocks[0].rotation, 1e-6);
    EXPECT_GT(frame.blocks[0].rotation, 0.2);
    for (const BoltNodeFrame& node : lastOf(solved, 0).bolts[0].nodes) EXPECT_EQ(node.axialForce, 0.0);
    for (const Frame& f : solved.results.frames)
        if (f.stage == 1 && f.time == 0.0)
            for (const BoltNodeFrame& node : f.bolts[0].nodes) {
                EXPECT_NEAR(node.axialForce, 0.0, 1e-3);
                EXPECT_NEAR(node.shearForce, 0.0, 1e-3);
                EXPECT_EQ(node.block, 0);
            }
}

/// The nut pulls at the first equilibrium of the stage that installs it and locks off there.
TEST(Installation, PretensionIsPutOnWhenTheBoltIsInstalled) {
    Scene scene = bolted(PlateKind::Spring, 20e3);
    Stage install = settle();
    install.name = "install";
    install.install = {scene.bolts[0].name};
    scene.stages = {settle(), install, loadStage(scene, 1.0, 1)};
    const Solved solved = solve(scene);
    EXPECT_TRUE(lastOf(solved, 0).bolts[0].nodes.empty());
    const BoltNodeFrame& head = lastOf(solved, 1).bolts[0].nodes.back();
    EXPECT_NEAR(std::abs(head.axialForce), 20e3, 1.0);
    EXPECT_NEAR(std::abs(lastOf(solved, 2).bolts[0].nodes.back().axialForce), 20e3, 10.0);
}

/// What a bolt stored goes with it.
TEST(Installation, ARemovedBoltReleasesWhatItStored) {
    Scene scene = bolted(PlateKind::None);
    Stage remove = settle();
    remove.name = "remove";
    remove.remove = {scene.bolts[0].name};
    scene.stages = {pulledTo(scene, "pull", 1e-3), remove};
    const Solved solved = solve(scene);
    const Frame &before = lastOf(solved, 0), &after = lastOf(solved, 1);
    ASSERT_GT(before.energy.bolt, 1.0);
    EXPECT_NEAR(after.energy.released - before.energy.released, before.energy.bolt, 1e-9 * before.energy.bolt);
    EXPECT_EQ(after.energy.bolt, 0.0);
    EXPECT_TRUE(after.bolts[0].nodes.empty());
    EXPECT_LT(std::abs(solved.results.stages[1].health.balanceError), 1e-9);
}

/// A plate that is a block comes and goes with its bolt.
TEST(Installation, APlateThatIsABlockComesAndGoesWithItsBolt) {
    Scene scene = bolted(PlateKind::Block, 20e3);
    scene.bolts[0].head = Point(2.0, 0.5);
    Stage install = settle(), remove = settle();
    install.name = "install";
    install.install = {scene.bolts[0].name};
    remove.name = "remove";
    remove.remove = {scene.bolts[0].name};
    scene.stages = {pulledTo(scene, "open", 1e-3), install, remove};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[1].outcome, Outcome::Equilibrium) << solved.results.stages[1].message;
    EXPECT_EQ(lastOf(solved, 0).blocks[2].area, 0.0);
    EXPECT_GT(lastOf(solved, 1).blocks[2].area, 0.0);
    EXPECT_NEAR(std::abs(lastOf(solved, 1).bolts[0].nodes.back().axialForce), 20e3, 1.0);
    EXPECT_EQ(lastOf(solved, 2).blocks[2].area, 0.0);
    EXPECT_TRUE(lastOf(solved, 2).contacts.empty());
}

}  // namespace
}  // namespace keyblock
