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

/// A slab that swings about a point support at its corner: in steps of 20 ms the turning strains the support.
Scene pendulum(double timeStep) {
    Scene scene = emptyScene(50e9, 0.2, 30.0);
    scene.analysis.gravity = {0.0, -gravity};
    scene.blocks = {boxBlock("slab", {0, 0}, {2, 1})};
    Support support;
    support.point = Point(0.0, 1.0);
    support.fix = Fix::XY;
    scene.supports = {support};
    scene.stages = {dynamic(1.0, timeStep)};
    return scene;
}

TEST(EnergyLimit, FailsAStageThatGainsEnergyAndNamesBlockAndStep) {
    const Results results = runInMemory(pendulum(0.02));
    const StageResult& stage = results.stages.at(0);
    EXPECT_EQ(stage.outcome, Outcome::Failed);
    EXPECT_LT(stage.time, 1.0);
    EXPECT_EQ(stage.blocks, std::vector<int>{0});
    EXPECT_NE(stage.message.find("block slab"), std::string::npos) << stage.message;
    EXPECT_NE(stage.message.find("0.01 s"), std::string::npos) << stage.message;
}

/// In steps of 2 ms 10 % of the energy is left over after 0.3 s.
TEST(EnergyLimit, ComparesWithTheLimitOfTheScene) {
    Scene scene = pendulum(2e-3);
    scene.stages[0].duration = 0.3;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Failed);
    scene.limits.energy = 0.2;
    EXPECT_EQ(runInMemory(scene).stages.at(0).outcome, Outcome::Duration);
    scene.stages[0].timeStep = 2e-4;
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
