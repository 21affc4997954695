// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A dynamic stage whose energy does not balance ends as failed; rock at rest and
// motion that has just begun, where the balance divides noise by noise, do not.
#include "solver/engine/setup/make_model.h"
#include "solver/run/energy_limit.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using test::dynamic;

/// A block that swings on a bolt at 6 m/s: bolts take their directions at the start of a step, which steps of 20 ms show.
Scene swing(double timeStep) {
    Scene scene = emptyScene(60e9, 0.2, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.analysis.tolerance = 1e-6;
    scene.blocks = {boxBlock("roof", {-1, 5}, {1, 6}), boxBlock("bob", {-0.5, 2}, {0.5, 3})};
    Support support;
    support.blockAt = Point(0.0, 5.5);
    scene.supports = {support};
    BoltType bar = linearType(1e-3, 200e9);
    bar.bending = Bending::None;
    bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9), anchorAt(3.0, AnchorLaw::Elastic, 1e9)};
    scene.boltTypes = {bar};
    Bolt bolt;
    bolt.name = "B";
    bolt.type = bar.name;
    bolt.farEnd = {0.0, 5.5};
    bolt.head = {0.0, 2.5};
    bolt.divisions = 3;
    bolt.plate = PlateKind::None;
    scene.bolts = {bolt};
    InitialVelocity start;
    start.blockAt = Point(0.0, 2.4);
    start.velocity = {6.0, 0.0};
    scene.stages = {dynamic(1.0, timeStep)};
    scene.stages[0].initialVelocities = {start};
    return scene;
}

TEST(EnergyLimit, FailsAStageThatGainsEnergyAndNamesBlockAndStep) {
    const Results results = runInMemory(swing(0.02));
    const StageResult& stage = results.stages.at(0);
    EXPECT_EQ(stage.outcome, Outcome::Failed);
    EXPECT_LT(stage.time, 1.0);
    EXPECT_EQ(stage.blocks, std::vector<int>{1});
    EXPECT_NE(stage.message.find("block bob"), std::string::npos) << stage.message;
    EXPECT_NE(stage.message.find("0.01 s"), std::string::npos) << stage.message;
}

TEST(EnergyLimit, ComparesWithTheLimitOfTheScene) {
    Scene scene = swing(0.02);
    scene.limits.energy = 0.95;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Duration);
    scene.stages[0].timeStep = 1e-3;
    scene.limits.energy = 0.05;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Duration);
}

/// Nothing moves, so that nothing but noise could be left over.
TEST(EnergyLimit, PassesManyStepsAtRest) {
    for (const Integration scheme :
         {Integration::Shi, Integration::BackwardEuler, Integration::Newmark, Integration::GeneralizedAlpha}) {
        Scene scene = emptyScene(50e9, 0.2, 30.0);
        scene.analysis.gravity = {0.0, -gravity};
        scene.analysis.integration = scheme;
        scene.blocks = {boxBlock("base", {-1, -1}, {3, 0}), boxBlock("block", {0, 0}, {2, 1})};
        Support support;
        support.blockAt = Point(0.0, -0.5);
        scene.supports = {support};
        Stage settle;
        settle.name = "settle";
        scene.stages = {settle, dynamic(2.0, 1e-3)};
        const Results results = runInMemory(scene);
        ASSERT_EQ(results.stages.size(), 2u);
        EXPECT_EQ(results.stages[1].outcome, Outcome::Duration) << results.stages[1].message;
    }
}

/// Without velocity, weight or load the energy is zero at first, and tiny for long.
TEST(EnergyLimit, PassesTheFirstStepsFromRest) {
    for (const double weight : {0.0, 1e-9, 9.81}) {
        Scene scene = emptyScene(50e9, 0.2, 30.0);
        scene.analysis.gravity = {0.0, -weight};
        scene.blocks = {boxBlock("block", {0, 0}, {2, 1})};
        scene.blocks[0].subBlocks = CellSettings{0.5};
        scene.stages = {dynamic(0.1, 1e-3)};
        EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Duration) << weight;
    }
}

/// An error counts from the stage's start, over the largest term, and not below 1e-3 of the largest energy there was.
TEST(EnergyExcess, ComparesWithTheRunAndWithNoise) {
    Scene scene = emptyScene(50e9, 0.2, 30.0);
    scene.blocks = {boxBlock("block", {0, 0}, {1, 1})};
    const Model model = makeModel(scene);
    State state = makeState(model);
    const std::vector<BlockMotion> start = state.blocks;
    state.energy.external = 5.0;  // of an earlier stage
    EnergyMark mark;
    markEnergy(model, state, mark);
    EXPECT_FALSE(energyExcess(model, state, start, 0.05, mark));
    state.blocks[0].velocity[0] = 0.02;  // 0.54 J
    const auto excess = energyExcess(model, state, start, 0.05, mark);
    ASSERT_TRUE(excess);
    EXPECT_NEAR(excess->share, 0.54 / 5.0, 1e-9);
    EXPECT_EQ(excess->block, 0);
    EXPECT_FALSE(energyExcess(model, state, start, 0.2, mark));
    mark.largest = 1e3;
    EXPECT_FALSE(energyExcess(model, state, start, 0.05, mark));
    mark = {};
    state = makeState(model);
    markEnergy(model, state, mark);
    state.blocks[0].velocity[0] = 1e-5;  // 1.35e-7 J, less than the 5e-7 J that are noise in such a block
    EXPECT_FALSE(energyExcess(model, state, start, 0.05, mark));
    state.blocks[0].velocity[0] = 1e-4;
    EXPECT_TRUE(energyExcess(model, state, start, 0.05, mark));
}

}  // namespace
}  // namespace keyblock
