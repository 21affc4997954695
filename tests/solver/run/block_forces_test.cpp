// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The frame lists every single force on a block: they sum to zero, and where a closed
// form is known, each has its value.
#include "solver/results/block_forces.h"

#include "solver/files/scene/scene_file.h"
#include "solver/verify/readings.h"
#include "tests/solver/run/bolt_scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

using test::boxOnBase;
using test::last;
using test::lastOf;
using test::settle;

/// Of the blocks of these scenes [kg/m³].
constexpr double cubeDensity = 2700.0;

struct Sum {
    Point force{0.0, 0.0};
    double moment = 0.0;
    int rows = 0;
};

Sum sumOf(const Frame& frame, int block, std::optional<ForceSource> source = std::nullopt) {
    Sum sum;
    for (const BlockForce& row : blockForces(frame)) {
        if (row.block != block || (source && row.source != *source)) continue;
        sum.force += row.force;
        sum.moment += row.moment;
        ++sum.rows;
    }
    return sum;
}

/// \param share of the block's weight [N], and of that times 1 m, that may be left.
void expectBalance(const Frame& frame, int block, double share) {
    const Sum sum = sumOf(frame, block);
    const double weight = frame.blocks[block].weight;
    EXPECT_GT(sum.rows, 1) << block;
    EXPECT_LT(sum.force.norm(), share * weight) << block << " at " << frame.time;
    EXPECT_LT(std::abs(sum.moment), share * weight) << block << " at " << frame.time;
}

/// Where no couples act, a moment is that of the force at its point.
void expectMomentsOfForces(const Frame& frame, int block) {
    const BlockState& state = frame.blocks[block];
    for (const BlockForce& row : blockForces(frame)) {
        if (row.block != block) continue;
        EXPECT_NEAR(row.moment, momentAbout(state.centroid, row.position, row.force), 1e-9 * state.weight);
    }
}

Support fixedBlock(const Point& place) {
    Support support;
    support.blockAt = place;
    return support;
}

TEST(BlockForces, ABlockOnASlopeHasItsNormalAndShearForce) {
    Scene scene = boxOnBase(20.0, 30.0);
    scene.stages = {settle()};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const Frame& frame = last(solved);
    const double weight = frame.blocks[1].weight;
    const Sum contacts = sumOf(frame, 1, ForceSource::Contact);
    EXPECT_NEAR(contacts.force.y(), weight * std::cos(20.0 * degree), 1e-3 * weight);
    EXPECT_NEAR(contacts.force.x(), -weight * std::sin(20.0 * degree), 1e-3 * weight);
    EXPECT_NEAR(sumOf(frame, 1, ForceSource::Weight).force.x(), weight * std::sin(20.0 * degree), 1e-9 * weight);
    expectBalance(frame, 1, 1e-3);
    expectBalance(frame, 0, 1e-9);  // the base by its reaction
    for (const BlockForce& row : blockForces(frame)) {
        if (row.source == ForceSource::Contact) { EXPECT_EQ(row.other, 1 - row.block); }
    }
}

/// A bolt with an anchor above the joint and a plate below it, nothing else.
Scene hungBlock(PlateKind plate) {
    Scene scene = gapBlocks(0.01);
    scene.analysis.gravity = {gravity, 0.0};
    scene.materials[0].second.density = cubeDensity;
    BoltType type = linearType(barArea(), 212e9);
    type.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 1e8, std::nullopt, 0.0)};
    addBolt(scene, type, 0.1, 2.01, 20, plate);
    scene.stages = {settle()};
    return scene;
}

TEST(BlockForces, ABoltCarriesTheWeightOfTheBlockThatHangsOnIt) {
    const Solved solved = solve(hungBlock(PlateKind::Spring));
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const Frame& frame = last(solved);
    const double weight = frame.blocks[1].weight;
    const Sum bolt = sumOf(frame, 1, ForceSource::Bolt);
    EXPECT_GT(bolt.rows, 5);
    EXPECT_NEAR(bolt.force.x(), -weight, 1e-3 * weight);
    expectMomentsOfForces(frame, 1);
    expectBalance(frame, 1, 1e-3);
    expectBalance(frame, 0, 1e-6);
}

TEST(BlockForces, PointLoadsAndPressuresAreRowsWithTheirMoments) {
    Scene scene = boxOnBase(0.0, 30.0);
    Stage stage = settle();
    Load force, pressure;
    force.point = Point(0.75, 1.0);
    force.force = {1e3, -4e3};
    pressure.along = {Point(0.0, 1.0), Point(0.5, 1.0)};
    pressure.pressure = 2e4;
    stage.loads = {force, pressure};
    scene.stages = {stage};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const Frame& frame = last(solved);
    const double thickness = scene.analysis.thickness;
    const Sum loads = sumOf(frame, 1, ForceSource::Load);
    EXPECT_EQ(loads.rows, 2);
    EXPECT_NEAR(loads.force.x(), 1e3, 1.0);
    EXPECT_NEAR(loads.force.y(), -4e3 - 1e4 * thickness, 1.0);
    // about the centroid (0.5, 0.5): the force by its arm (0.25, 0.5), the pressure by −0.25
    EXPECT_NEAR(loads.moment, -4e3 * 0.25 - 1e3 * 0.5 + 0.25 * 1e4 * thickness, 1.0);
    expectBalance(frame, 1, 1e-3);
}

TEST(BlockForces, CellsOfABlockBalanceByTheirBonds) {
    Scene scene = boxOnBase(0.0, 30.0);
    scene.blocks[1] = boxBlock("box", {0, 0}, {1, 2});
    scene.blocks[1].subBlocks = CellSettings{0.7};
    scene.stages = {settle()};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium);
    const Frame& frame = last(solved);
    ASSERT_GT(frame.blocks.size(), 2U);
    for (int cell = 1; cell < static_cast<int>(frame.blocks.size()); ++cell) {
        EXPECT_GT(sumOf(frame, cell, ForceSource::Glue).rows, 0);
        expectBalance(frame, cell, 2e-3);
    }
}

/// A lid on three columns, of which the middle one is excavated and half of its force released.
TEST(BlockForces, WallsHoldWhatIsNotReleased) {
    Scene scene = emptyScene(1e10, 0.0, 30.0);
    scene.blocks = {boxBlock("base", {0, -1}, {5, 0}), boxBlock("left", {0, 0}, {1, 1}),
                    boxBlock("middle", {2, 0}, {3, 1}), boxBlock("right", {4, 0}, {5, 1}),
                    boxBlock("lid", {0, 1}, {5, 2})};
    scene.supports = {fixedBlock({2.5, -0.5})};
    scene.analysis.gravity = {0.0, -gravity};
    Stage excavation = settle();
    excavation.name = "excavate";
    excavation.excavate = {"middle"};
    excavation.relaxation = 0.5;
    scene.stages = {settle(), excavation};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[1].outcome, Outcome::Equilibrium);
    const auto& frames = solved.results.frames;
    const auto held = std::find_if(frames.begin(), frames.end(), [](const Frame& f) { return f.stage == 1; });
    const double before = sumOf(*held, 4, ForceSource::Wall).force.y();
    EXPECT_GT(before, 0.1 * last(solved).blocks[4].weight);
    EXPECT_NEAR(sumOf(last(solved), 4, ForceSource::Wall).force.y(), 0.5 * before, 1e-9 * before);
    EXPECT_EQ(sumOf(last(solved), 2).rows, 0);  // excavated
    for (int block : {1, 3, 4}) expectBalance(last(solved), block, 1e-3);
}

TEST(BlockForces, ABlockHeldAtPointsAndOneThatIsDrivenShowReactions) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("held", {0, 0}, {1, 1}), boxBlock("driven", {2, 0}, {3, 1})};
    scene.analysis.gravity = {0.0, -gravity};
    Support left, right;
    left.point = Point(0.0, 0.0);
    left.fix = Fix::XY;
    right.point = Point(1.0, 0.0);
    right.fix = Fix::Y;
    scene.supports = {left, right};
    Stage stage = settle();
    Motion motion;
    motion.blockAt = Point(2.5, 0.5);
    motion.axis = {0.0, 1.0};
    motion.table = {{0.0, 0.0}, {1.0, 1e-3}};
    stage.motions = {motion};
    scene.stages = {stage};
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages[0].outcome, Outcome::Equilibrium) << solved.results.stages[0].message;
    const Frame& frame = last(solved);
    EXPECT_EQ(sumOf(frame, 0, ForceSource::Support).rows, 2);
    expectMomentsOfForces(frame, 0);
    for (int block : {0, 1}) {
        const double weight = frame.blocks[block].weight;
        EXPECT_NEAR(sumOf(frame, block, ForceSource::Support).force.y(), weight, 1e-3 * weight);
        expectBalance(frame, block, 1e-3);
    }
}

TEST(BlockForces, InertiaOfAFreeFallIsTheWeightTurnedRound) {
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler, Integration::Newmark,
                                     Integration::GeneralizedAlpha}) {
        Scene scene = boxOnBase(0.0, 30.0);
        for (Point& p : scene.blocks[1].points) p.y() += 5.0;
        Stage stage = test::dynamic(0.05, 1e-3);
        stage.integration = scheme;
        scene.stages = {stage};
        const Solved solved = solve(scene);
        for (const Frame& frame : solved.results.frames) {
            const double weight = frame.blocks[1].weight;
            const Sum inertia = sumOf(frame, 1, ForceSource::Inertia);
            EXPECT_NEAR(inertia.force.y(), weight, 1e-6 * weight);
            EXPECT_NEAR(inertia.force.x(), 0.0, 1e-6 * weight);
            expectBalance(frame, 1, 1e-6);
        }
    }
}

/// A block that slides down a slope has what its friction leaves of its weight as inertia.
TEST(BlockForces, ASlidingBlockBalancesInEveryFrameUnderEveryScheme) {
    for (const Integration scheme : {Integration::Shi, Integration::BackwardEuler, Integration::Newmark,
                                     Integration::GeneralizedAlpha}) {
        Scene scene = inclineScene(40.0, 20.0, 0.2);
        scene.stages[0].integration = scheme;
        scene.output.frames = 10;
        const Solved solved = solve(scene);
        for (const Frame& frame : solved.results.frames) expectBalance(frame, 1, 2e-3);
        const Frame& frame = last(solved);
        const double weight = frame.blocks[1].weight;
        const double slides = weight * (std::sin(40.0 * degree) - std::tan(20.0 * degree) * std::cos(40.0 * degree));
        EXPECT_NEAR(sumOf(frame, 1, ForceSource::Inertia).force.norm(), slides, 0.02 * weight);
    }
}

/// A column pushed by its weight onto a side that lets waves out: what held it is kept, dashpots resist its motion.
TEST(BlockForces, TheSupportOfASwingingBlockHasTheMomentOfItsForce) {
    for (const Integration scheme : {Integration::Shi, Integration::Newmark, Integration::GeneralizedAlpha}) {
        Scene scene = emptyScene(10e9, 0.25, 30.0);
        scene.analysis.gravity = {0.0, -gravity};
        scene.blocks = {boxBlock("pendulum", {0.0, 0.0}, {1.0, 0.5})};
        Support support;
        support.point = Point(0.1, 0.2);
        support.fix = Fix::XY;
        scene.supports = {support};
        Stage swing;
        swing.name = "swing";
        swing.kind = StageKind::Dynamic;
        swing.duration = 0.4;
        swing.timeStep = 2e-3;
        swing.integration = scheme;
        scene.stages = {swing};
        const Solved solved = solve(scene);
        const Frame& frame = last(solved);
        expectBalance(frame, 0, 1e-6);
        const BlockState& state = frame.blocks[0];
        int rows = 0;
        for (const BlockForce& row : blockForces(frame)) {
            if (row.source != ForceSource::Support) continue;
            ++rows;
            EXPECT_NEAR(row.moment, momentAbout(state.centroid, row.position, row.force), 1e-5 * state.weight);
        }
        EXPECT_EQ(rows, 1);
    }
}

TEST(BlockForces, DashpotsAndKeptSupportsBalanceABlockOnAViscousSide) {
    Scene scene = emptyScene(1e9, 0.0, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    scene.analysis.gravity = {0.0, -gravity};
    Support left, right;
    left.point = Point(0.0, 0.0);
    right.point = Point(1.0, 0.0);
    left.fix = right.fix = Fix::XY;
    scene.supports = {left, right};
    Stage stage = test::dynamic(0.02, 1e-4);
    stage.viscousBoundaries = {"bottom"};
    Load push;
    push.point = Point(0.5, 1.0);
    push.force = {0.0, -1e5};
    stage.loads = {push};
    scene.stages = {settle(), stage};
    scene.output.frames = 10;
    const Solved solved = solve(scene);
    const Frame& frame = last(solved);
    EXPECT_GT(sumOf(frame, 0, ForceSource::Dashpot).force.y(), 0.1 * frame.blocks[0].weight);
    EXPECT_NEAR(sumOf(frame, 0, ForceSource::Support).force.y(), frame.blocks[0].weight, 1e-3 * frame.blocks[0].weight);
    for (const Frame& each : solved.results.frames)
        if (each.stage == 1) expectBalance(each, 0, 2e-3);
}

/// The static stages of the sample, and the beginning of its release at rest, which its bolts follow.
TEST(BlockForces, EveryBlockOfTheBoltedDriftBalancesAtRest) {
    const SceneReading sample = readSceneFile(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json");
    ASSERT_TRUE(sample.scene);
    Scene scene = sample.cut ? sample.cut->scene : *sample.scene;
    scene.stages.resize(4);
    scene.stages[3] = settle();
    scene.stages[3].relaxation = 0.4;
    scene.output.frames = 4;
    const Solved solved = solve(scene);
    ASSERT_EQ(solved.results.stages.size(), 4U);
    int blocks = 0, bolted = 0;
    for (int stage : {2, 3}) {
        const Frame& frame = lastOf(solved, stage);
        for (int block = 0; block < static_cast<int>(frame.blocks.size()); ++block) {
            if (frame.blocks[block].area < 0.01) continue;
            expectBalance(frame, block, 2e-3);
            ++blocks;
            if (sumOf(frame, block, ForceSource::Bolt).force.norm() > 1.0) ++bolted;
        }
    }
    EXPECT_GT(blocks, 500);
    EXPECT_GT(bolted, 5);
}

TEST(BlockForces, AFrameWithoutForcesHasNone) {
    Frame frame;
    frame.blocks.resize(2);
    EXPECT_TRUE(blockForces(frame).empty());
}

}  // namespace
}  // namespace keyblock
