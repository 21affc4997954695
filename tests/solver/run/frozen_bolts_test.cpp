// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bolts whose forces stay as they were: factors of safety in closed form, and a
// scene with dead loads against the one with the bolts.
#include "solver/run/frozen_bolts.h"

#include "solver/results/block_forces.h"
#include "solver/run/safety.h"
#include "solver/run/strength_reduction.h"
#include "solver/scene/check.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace keyblock {
namespace {

using test::safetyOf;
using test::settle;
using test::weight;

constexpr double slopeDip = 30.0, jointFriction = 25.0;  // [°]
constexpr double pretension = 8e3;  // [N]

/// A box on a slope that would slide, held by a pretensioned bar from a fixed wall up the slope; the bar is elastic and
/// unbreakable, anchored at its far end and by its plate on the lower face of the box.
Scene boltedSlope(PlateKind plate) {
    Scene scene = test::boxOnBase(slopeDip, jointFriction);
    scene.blocks.push_back(boxBlock("wall", {-4, 0}, {-3, 1}));
    scene.blocks[0].points = {{-5, -1}, {9, -1}, {9, 0}, {-5, 0}};
    Support wall;
    wall.blockAt = Point(-3.5, 0.5);
    scene.supports.push_back(wall);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9)};
    type.normalStiffness = 1e3;
    addBolt(scene, type, -3.5, 1.0, 9, plate);
    Bolt& bolt = scene.bolts.back();
    bolt.farEnd = {-3.5, 0.25};
    bolt.head = {1.0, 0.25};
    bolt.pretension = pretension;
    scene.monitors.clear();
    scene.stages = {settle()};
    scene.safety = {Reduce::Joints, 0.002, BoltForces::Frozen};
    return scene;
}

std::vector<StageFrames> framesOf(const Results& results) {
    std::vector<StageFrames> stages;
    for (const Frame& frame : results.frames) {
        if (static_cast<std::size_t>(frame.stage) == stages.size()) stages.push_back({frame, frame});
        stages.back().last = frame;
    }
    return stages;
}

/// What bolts and plates put on the box [N].
Point boltForceOnBox(const Frame& frame) {
    Point sum(0.0, 0.0);
    for (const BlockForce& force : blockForces(frame))
        if (force.block == 1 && (force.source == ForceSource::Bolt || force.other > 2)) sum += force.force;
    return sum;
}

/// Friction over what drives the box down the slope, with the bolt's forces as they are at the end of a run.
double factorOf(const Frame& frame, double load) {
    const Point bolt = boltForceOnBox(frame);
    const double pressed = weight * std::cos(slopeDip * degree) - bolt.y();
    return pressed * std::tan(jointFriction * degree) / (weight * std::sin(slopeDip * degree) + load + bolt.x());
}

/// After the pretension is locked in, a force pushes the box down the slope.
Scene loadedSlope(PlateKind plate, double force) {
    Scene scene = boltedSlope(plate);
    scene.stages.push_back(settle());
    scene.stages[1].name = "load";
    Load load;
    load.point = Point(0.0, 0.25);
    load.force = {force, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    scene.stages[1].loads = {load};
    return scene;
}

/// F = (W cos α + T_n) tan φ / (W sin α + P − T), the bolt's force along the slope T and across it T_n (a little of its own
/// weight) as at a factor of 1.
TEST(FrozenBolts, HoldTheSlopeByTheForceThatTheyHad) {
    for (const PlateKind plate : {PlateKind::Spring, PlateKind::Block})
        for (const double load : {0.0, 4e3}) {
            SCOPED_TRACE(std::to_string(static_cast<int>(plate)) + " under " + std::to_string(load));
            const Scene scene = load > 0.0 ? loadedSlope(plate, load) : boltedSlope(plate);
            const Results first = runInMemory(scene);
            ASSERT_EQ(first.stages.back().outcome, Outcome::Equilibrium);
            EXPECT_NEAR(-boltForceOnBox(first.frames.back()).x(), pretension, 0.2 * pretension);
            const double expected = factorOf(first.frames.back(), load);
            const SafetyFactor found = safetyOf(scene);
            ASSERT_TRUE(found.lower && found.upper);
            EXPECT_LE(*found.lower, expected * 1.002);
            EXPECT_GE(*found.upper, expected * 0.998);
        }
}

/// Under the load the bar stretches as the box slides a little: it falls only where the pretension alone, which a jack
/// keeps until the first equilibrium, does not hold the box.
TEST(FrozenBolts, MobilisedOnesHoldMore) {
    Scene scene = loadedSlope(PlateKind::Spring, 4e3);
    const SafetyFactor frozen = safetyOf(scene);
    scene.safety.boltForces = BoltForces::Mobilised;
    const SafetyFactor mobilised = safetyOf(scene);
    ASSERT_TRUE(frozen.upper && mobilised.lower && mobilised.upper);
    EXPECT_LT(*frozen.upper, 1.3);
    const double alone = weight * std::cos(slopeDip * degree) * std::tan(jointFriction * degree) /
                         (weight * std::sin(slopeDip * degree) - pretension);
    EXPECT_NEAR(*mobilised.lower, alone, 0.01 * alone);
}

TEST(FrozenBolts, AreNotFoundWhereTheSceneFails) {
    Scene scene = boltedSlope(PlateKind::None);
    scene.bolts[0].pretension = 0.0;
    const SafetyFactor found = safetyOf(scene);
    EXPECT_TRUE(found.nothingToFreeze);
    EXPECT_EQ(found.runs.size(), 1u);
    EXPECT_EQ(found.upper, 1.0);
    EXPECT_FALSE(found.lower || found.cutShort);
}

/// Three stages, the bolt installed in the second, more load in the third: with dead loads in place of the bolt every
/// contact carries the same at the end of each of them.
TEST(FrozenBolts, LeaveTheForcesOfEveryStageAsTheyWere) {
    Scene scene = boltedSlope(PlateKind::Spring);
    scene.jointMaterials[0].second.frictionAngle = 35.0;
    scene.stages = {settle(), settle(), settle()};
    scene.stages[1].name = "bolt";
    scene.stages[1].install = {scene.bolts[0].name};
    scene.stages[2].name = "load";
    Load load;
    load.blockAt = Point(0.5, 0.5);
    load.force = {5e3, -1e3};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    scene.stages[2].loads = {load};
    const Results bolted = runInMemory(scene);
    ASSERT_EQ(bolted.stages.size(), 3u);
    const Scene frozen = withFrozenBolts(scene, framesOf(bolted));
    for (const Problem& problem : checkScene(frozen)) EXPECT_NE(problem.severity, Severity::Error) << problem.message;
    EXPECT_TRUE(frozen.bolts.empty() && frozen.stages[1].install.empty());
    EXPECT_TRUE(frozen.stages[0].loads.empty());
    const Results loaded = runInMemory(frozen);
    ASSERT_EQ(loaded.stages.size(), 3u);
    const std::vector<StageFrames> expected = framesOf(bolted), found = framesOf(loaded);
    for (std::size_t stage = 0; stage < 3; ++stage) {
        EXPECT_EQ(loaded.stages[stage].outcome, Outcome::Equilibrium);
        std::map<std::pair<int, int>, Point> sums[2];
        for (int which : {0, 1})
            for (const BlockForce& force : blockForces((which == 0 ? expected : found)[stage].last))
                if (force.block == 1 && force.source == ForceSource::Contact)
                    sums[which].try_emplace({force.block, force.other}, Point(0.0, 0.0)).first->second += force.force;
        ASSERT_FALSE(sums[0].empty());
        for (const auto& [pair, sum] : sums[0]) EXPECT_NEAR((sums[1][pair] - sum).norm(), 0.0, 2e-3 * weight) << stage;
    }
}

TEST(FrozenBolts, AreNoLongerNamed) {
    Scene scene = boltedSlope(PlateKind::Spring);
    Monitor onBolt, point;
    onBolt.name = "force";
    onBolt.bolt = scene.bolts[0].name;
    onBolt.atFraction = 0.5;
    point.name = "box";
    point.point = Point(0.5, 0.5);
    scene.monitors = {onBolt, point};
    scene.quantities = {"max " + scene.bolts[0].name + ".axial_force", "last force", "last box.ux"};
    scene.about.expected = {{"last force", 1.0, 0.1, ""}, {"last box.ux", 0.0, 0.1, ""}};
    const Scene frozen = withFrozenBolts(scene, framesOf(runInMemory(scene)));
    ASSERT_EQ(frozen.monitors.size(), 1u);
    EXPECT_EQ(frozen.monitors[0].name, "box");
    EXPECT_EQ(frozen.quantities, std::vector<std::string>{"last box.ux"});
    ASSERT_EQ(frozen.about.expected.size(), 1u);
    EXPECT_EQ(frozen.about.expected[0].quantity, "last box.ux");
    ASSERT_FALSE(frozen.stages[0].loads.empty());
    EXPECT_TRUE(frozen.stages[0].loads[0].table.empty()) << "acts as gravity does";
}

TEST(FrozenBolts, HaveNoBondsToReduce) {
    Scene scene = boltedSlope(PlateKind::Spring);
    EXPECT_TRUE(checkSafety(scene).empty());
    scene.safety.reduce = Reduce::Both;
    const std::vector<Problem> problems = checkSafety(scene);
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].pointer, "/safety/bolt_forces");
}

}  // namespace
}  // namespace keyblock
