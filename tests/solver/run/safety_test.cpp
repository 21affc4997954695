// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Factors of safety that limit equilibrium gives in closed form: friction, cohesion
// and bonds, each alone; and the search itself, held to a factor that is known.
#include "solver/run/safety.h"
#include "solver/run/strength_reduction.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using test::safetyOf;
using test::settle;
using test::weight;

void expectBracket(const Scene& scene, const SafetyFactor& found, double factor) {
    ASSERT_TRUE(found.lower && found.upper);
    EXPECT_LE(*found.upper - *found.lower, scene.safety.tolerance);
    // the pass tolerance is what a run may take for balance
    EXPECT_LE(*found.lower, factor * (1.0 + 1e-3));
    EXPECT_GE(*found.upper, factor * (1.0 - 1e-3));
    for (const SafetyRun& run : found.runs) EXPECT_EQ(run.stands, run.factor <= *found.lower) << run.factor;
}

/// A box on a slope of 30°.
Scene slopeScene(double frictionAngle) {
    Scene scene = test::boxOnBase(30.0, frictionAngle);
    scene.stages = {settle()};
    return scene;
}

/// A cube of 1 m that hangs in +x from a fixed one, on a bolt alone.
Scene hungScene(const std::vector<Anchor>& anchors) {
    Scene scene = twoBlocks(60e9, 1.0, 2.0);
    scene.analysis.gravity = {gravity, 0.0};
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = anchors;
    addBolt(scene, type, 0.0, 2.0, 20, PlateKind::Spring);
    scene.stages = {settle()};
    scene.safety.reduce = Reduce::Bonds;
    return scene;
}

TEST(SafetySearch, ClosesInOnTheFactor) {
    for (const double known : {1.2345, 0.3, 37.0, 0.0011, 999.0}) {
        std::optional<double> lower, upper;
        int tries = 0;
        while (const auto factor = nextSafetyFactor(lower, upper, 0.01)) {
            (*factor <= known ? lower : upper) = *factor;
            ASSERT_LT(++tries, 40);
        }
        ASSERT_TRUE(lower && upper);
        EXPECT_LE(*lower, known);
        EXPECT_GT(*upper, known);
        EXPECT_LE(*upper - *lower, 0.01);
    }
}

TEST(SafetySearch, EndsWhereNothingIsFound) {
    EXPECT_EQ(nextSafetyFactor({}, {}, 0.01), 1.0);
    EXPECT_EQ(nextSafetyFactor(512.0, {}, 0.01), mostSafety);
    EXPECT_EQ(nextSafetyFactor(mostSafety, {}, 0.01), std::nullopt);
    EXPECT_EQ(nextSafetyFactor({}, 1.0 / 512.0, 0.01), leastSafety);
    EXPECT_EQ(nextSafetyFactor({}, leastSafety, 0.01), std::nullopt);
}

TEST(ReducedStrength, DividesWhatIsAskedForAndNothingElse) {
    Scene scene = hungScene({anchorRange(Per::Length, AnchorLaw::PeakResidual, 1e8, 50e3, 20e3)});
    scene.jointMaterials[0].second = {.frictionAngle = 45.0, .cohesion = 1e5, .tensileStrength = 4e4,
                                      .residualFrictionAngle = 30.0, .crushingStrength = 1e8};
    scene.stages[0].set = {{.jointMaterial = scene.jointMaterials[0].first, .frictionAngle = 45.0, .cohesion = 0.0,
                            .tensileStrength = std::nullopt}};
    scene.stages[0].continueAfterCollapse = false;
    for (const Reduce reduce : {Reduce::Joints, Reduce::Bonds, Reduce::Both}) {
        scene.safety.reduce = reduce;
        EXPECT_EQ(withReducedStrength(scene, 1.0), scene);
        const Scene half = withReducedStrength(scene, 2.0);
        const double joints = reduce == Reduce::Bonds ? 1.0 : 2.0, bonds = reduce == Reduce::Joints ? 1.0 : 2.0;
        const JointMaterial& joint = half.jointMaterials[0].second;
        EXPECT_NEAR(std::tan(joint.frictionAngle * degree), 1.0 / joints, 1e-14);
        EXPECT_NEAR(std::tan(*joint.residualFrictionAngle * degree), std::tan(30.0 * degree) / joints, 1e-14);
        EXPECT_EQ(joint.cohesion, 1e5 / joints);
        EXPECT_EQ(joint.tensileStrength, 4e4 / joints);
        EXPECT_EQ(joint.crushingStrength, 1e8);
        EXPECT_NEAR(std::tan(*half.stages[0].set[0].frictionAngle * degree), 1.0 / joints, 1e-14);
        EXPECT_FALSE(half.stages[0].set[0].tensileStrength);
        const Anchor& anchor = half.boltTypes[0].anchors[0];
        EXPECT_EQ(anchor.strength, 50e3 / bonds);
        EXPECT_EQ(anchor.residual, 20e3 / bonds);
        EXPECT_EQ(anchor.stiffness, 1e8);
    }
}

TEST(ReducedStrength, ACurveKeepsItsSlopes) {
    Anchor anchor;
    anchor.law = AnchorLaw::Curve;
    anchor.curve = {{0.0, 0.0}, {0.002, 90e3}, {0.6, 98e3}};
    const Scene half = withReducedStrength(hungScene({anchor}), 2.0);
    EXPECT_EQ(half.boltTypes[0].anchors[0].curve, (Table{{0.0, 0.0}, {0.001, 45e3}, {0.3, 49e3}}));
}

TEST(ReducedStrength, FrictionThatNoSceneNamesIsReducedToo) {
    Scene scene = slopeScene(30.0);
    scene.jointMaterials.clear();
    for (Block& block : scene.blocks) block.jointMaterial.reset();
    EXPECT_NEAR(withReducedStrength(scene, 2.0).jointMaterials.at(0).second.frictionAngle,
                std::atan(std::tan(30.0 * degree) / 2.0) / degree, 1e-12);
}

/// F = tan φ / tan α.
TEST(Safety, OfABlockOnASlopeIsTanPhiOverTanAlpha) {
    for (const double friction : {40.0, 20.0, 29.0}) {
        SCOPED_TRACE(friction);
        const Scene scene = slopeScene(friction);
        const SafetyFactor found = safetyOf(scene);
        expectBracket(scene, found, std::tan(friction * degree) / std::tan(30.0 * degree));
        ASSERT_TRUE(found.mode);
        ASSERT_EQ(found.mode->blocks.size(), 1u);
        EXPECT_EQ(found.mode->blocks[0].block, 1);
        EXPECT_EQ(found.mode->blocks[0].movement, Movement::Slides);
        EXPECT_GT(found.mode->blocks[0].displacement.x(), 0.0);
        ASSERT_EQ(found.mode->joints.size(), 1u);
        EXPECT_GT(found.mode->joints[0].slip, 10.0 * found.mode->joints[0].opening);
    }
}

/// F = (c·L + W cos α tan φ) / (W sin α), of a rigid block whose centroid stands plumb above the middle of the joint,
/// so that both ends of the joint let go at once: cohesion is lost when it is passed.
TEST(Safety, OfABondedBlockAddsItsCohesion) {
    Scene scene = slopeScene(20.0);
    scene.materials[0].second.youngsModulus = rigidRock;
    const double lean = std::tan(30.0 * degree);
    scene.blocks[1].points = {{0, 0}, {1, 0}, {1 - lean, 1}, {-lean, 1}};
    JointMaterial& joint = scene.jointMaterials[0].second;
    joint.cohesion = 10e3;
    joint.normalStiffness = 1e9;
    joint.shearStiffness = 4e8;
    const double along = weight * std::sin(30.0 * degree), across = weight * std::cos(30.0 * degree);
    expectBracket(scene, safetyOf(scene), (joint.cohesion + across * std::tan(20.0 * degree)) / along);
}

/// F = strength / weight: of an anchor that lets go, of one that slides along a curve.
TEST(Safety, OfAHungBlockIsStrengthOverWeight) {
    Anchor shell = anchorAt(0.0, AnchorLaw::PeakResidual, 5e7);
    shell.strength = 60e3;
    Anchor curve = anchorAt(0.0, AnchorLaw::Curve, 0.0);
    curve.curve = {{0.0, 0.0}, {0.002, 45e3}, {0.1, 50e3}};
    const std::pair<Anchor, double> cases[]{{shell, 60e3}, {curve, 50e3}};
    for (const auto& [anchor, strength] : cases) {
        SCOPED_TRACE(strength);
        const Scene scene = hungScene({anchor});
        expectBracket(scene, safetyOf(scene), strength / weight);
    }
    // joints that carry nothing here, divided as well, change nothing
    Scene both = hungScene({shell});
    both.safety.reduce = Reduce::Both;
    expectBracket(both, safetyOf(both), 60e3 / weight);
}

TEST(Safety, TellsWhatNothingBringsDown) {
    Scene scene = test::boxOnBase(0.0, 30.0);
    scene.stages = {settle()};
    const SafetyFactor found = safetyOf(scene);
    EXPECT_EQ(found.lower, mostSafety);
    EXPECT_FALSE(found.upper || found.mode || found.cutShort);
}

/// A slab five times as high as it is wide topples on 30°, whatever the friction.
TEST(Safety, TellsWhatNoStrengthHolds) {
    Scene scene = slopeScene(60.0);
    scene.blocks[1] = boxBlock("box", {0, 0}, {0.2, 1});
    const SafetyFactor found = safetyOf(scene);
    EXPECT_EQ(found.upper, leastSafety);
    EXPECT_FALSE(found.lower);
    ASSERT_TRUE(found.mode);
    ASSERT_EQ(found.mode->blocks.size(), 1u);
    EXPECT_EQ(found.mode->blocks[0].movement, Movement::Topples);
    EXPECT_LT(found.mode->blocks[0].rotation, 0.0);
}

TEST(Safety, ABlockThatNothingHoldsFalls) {
    Anchor shell = anchorAt(0.0, AnchorLaw::PeakResidual, 5e7);
    shell.strength = 30e3;
    const SafetyFactor found = safetyOf(hungScene({shell}));
    ASSERT_TRUE(found.mode && !found.mode->blocks.empty());
    EXPECT_EQ(found.mode->blocks[0].block, 1);
    EXPECT_EQ(found.mode->blocks[0].movement, Movement::Falls);
}

/// A box that slides 1 m to a stop lies still there, but did not stand.
TEST(Safety, ABlockThatSlidesToARestElsewhereDidNotStand) {
    Scene scene = slopeScene(40.0);
    scene.blocks.push_back(boxBlock("stop", {2, 0}, {3, 1}));
    Support held;
    held.blockAt = Point(2.5, 0.5);
    scene.supports.push_back(held);
    const SafetyFactor found = safetyOf(scene);
    expectBracket(scene, found, std::tan(40.0 * degree) / std::tan(30.0 * degree));
    EXPECT_FALSE(found.runs[1].stands);
    EXPECT_EQ(found.runs[1].end.outcome, Outcome::Displaced);
}

/// A quarter beside it, then three quarters; a tenth less and more where there is no bracket yet.
TEST(NextSafetyFactor, LiesBesideARunWithoutAVerdict) {
    EXPECT_DOUBLE_EQ(nextSafetyFactor(1.0, 2.0, 0.01, 0).value(), 1.5);
    EXPECT_DOUBLE_EQ(nextSafetyFactor(1.0, 2.0, 0.01, 1).value(), 1.25);
    EXPECT_DOUBLE_EQ(nextSafetyFactor(1.0, 2.0, 0.01, 2).value(), 1.75);
    EXPECT_EQ(nextSafetyFactor(1.0, 2.0, 0.01, 3), std::nullopt);
    EXPECT_DOUBLE_EQ(nextSafetyFactor({}, {}, 0.01, 1).value(), 0.9);
    EXPECT_DOUBLE_EQ(nextSafetyFactor(1.0, {}, 0.01, 2).value(), 2.2);
}

/// Runs between 1.4 and 1.6 are cut short by hand.
TEST(Safety, ARunWithoutAVerdictIsLeftOut) {
    const Scene scene = slopeScene(40.0);
    const SafetyFactor found = findSafetyFactor(scene, [&](Scene reduced, double factor, Sink& sink) {
        Control control;
        if (factor > 1.4 && factor < 1.6) reduced.limits.iterations = 1;
        run(reduced, sink, control);
    });
    EXPECT_EQ(found.runs.at(2).end.outcome, Outcome::Undecided);
    EXPECT_DOUBLE_EQ(found.runs.at(3).factor, 1.25);
    EXPECT_EQ(found.cutShort, Outcome::Undecided);  // after 1.625, 1.4375, 1.34375, and three between these ends
    EXPECT_DOUBLE_EQ(found.lower.value(), 1.34375);
    EXPECT_DOUBLE_EQ(found.upper.value(), 1.625);
}

TEST(Safety, AStopLeavesTheBracketSoFar) {
    Control control;
    const Scene scene = slopeScene(40.0);
    const SafetyFactor found = findSafetyFactor(scene, [&](const Scene& reduced, double factor, Sink& sink) {
        control.stop = factor > 1.0 && factor < 2.0;
        run(reduced, sink, control);
    });
    EXPECT_EQ(found.lower, 1.0);
    EXPECT_EQ(found.upper, 2.0);
    EXPECT_EQ(found.cutShort, Outcome::Stopped);
    EXPECT_EQ(found.runs.size(), 2u);
}

std::string firstPointer(const Scene& scene) {
    const std::vector<Problem> problems = checkSafety(scene);
    return problems.empty() ? "none" : problems[0].pointer;
}

TEST(SafetyCheck, RefusesWhatHasNoFactor) {
    Scene scene = slopeScene(30.0);
    EXPECT_EQ(firstPointer(scene), "none");
    scene.safety.reduce = Reduce::Bonds;
    EXPECT_EQ(firstPointer(scene), "/safety/reduce");
    scene.safety.reduce = Reduce::Both;
    EXPECT_EQ(firstPointer(scene), "none");
    scene.jointMaterials[0].second.frictionAngle = 0.0;
    EXPECT_EQ(firstPointer(scene), "/safety/reduce");
    scene = slopeScene(30.0);
    scene.stages.push_back(test::dynamic(1.0, 0.01));
    EXPECT_EQ(firstPointer(scene), "/stages/1/kind");
    scene.stages.clear();
    EXPECT_EQ(firstPointer(scene), "/stages");
}

}  // namespace
}  // namespace keyblock
