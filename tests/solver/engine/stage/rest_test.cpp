// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// When a block counts as at rest: by its own weight, whatever else acts on it or in
// the scene; without gravity by what acts on it from outside.
#include "solver/engine/stage/rest.h"

#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/step_forces.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

constexpr double density = 2700.0, pebbleWeight = density * 1e-4 * gravity, mountainWeight = density * 100.0 * gravity;

/// A pebble and a mountain that float apart, each under forces of its own [N].
struct Floating {
    Model model;
    State state;
    Loads loads;
    LoadPoint at;

    explicit Floating(double g = gravity) : model(makeModel(scene(g))), state(makeState(model)) { at.gravity = 1.0; }

    /// At the centroid.
    void push(int block, const Point& force) {
        loads.forces.push_back({.block = block, .force = force});
        at.forces.push_back(1.0);
    }

    Unrest judge(double share = 1e-3) {
        StepProblem problem = buildStep(model, state, loads, at, {Inertia::Static, 1e-3});
        const Eigen::VectorXd net = netForce(problem, Eigen::VectorXd::Zero(problem.unknowns()));
        const RestForces rest = restForces(model, state, problem, weightPerMass(model, at));
        return farthestFromRest(model, state, problem, rest, net, share);
    }

    static Scene scene(double g) {
        Scene two = emptyScene(10e9, 0.2, 30.0);
        two.analysis.gravity = {0.0, -g};
        two.blocks = {boxBlock("pebble", {0, 0}, {0.01, 0.01}), boxBlock("mountain", {10, 0}, {20, 10})};
        return two;
    }
};

TEST(Rest, ComparesWhatIsLeftWithTheWeightOfTheBlock) {
    Floating floating;
    floating.push(0, {0.0, pebbleWeight});
    floating.push(1, {0.0, 0.8 * mountainWeight});
    const Unrest unrest = floating.judge();
    EXPECT_EQ(unrest.body, 1);
    EXPECT_NEAR(unrest.share, 0.2, 1e-9);
    EXPECT_NEAR(unrest.beyond, 200.0, 1e-6);
    EXPECT_EQ(unrest.restless, std::vector<int>{1});
}

TEST(Rest, SeesAPebbleBesideAMountain) {
    Floating floating;
    floating.push(1, {0.0, (1.0 - 1e-4) * mountainWeight});  // what is left of it is a thousand pebbles
    floating.push(0, {0.0, 0.5 * pebbleWeight});
    const Unrest unrest = floating.judge();
    EXPECT_EQ(unrest.body, 0);
    EXPECT_NEAR(unrest.share, 0.5, 1e-9);
    EXPECT_EQ(unrest.restless, std::vector<int>{0});
}

/// Two forces that balance each other are none of a block's weight.
TEST(Rest, IsNotHiddenByWhatClampsABlock) {
    for (const double clamp : {0.0, 1.0, 1e6}) {
        Floating floating;
        floating.push(1, {0.0, mountainWeight});
        floating.push(0, {clamp * pebbleWeight, 0.9 * pebbleWeight});
        floating.push(0, {-clamp * pebbleWeight, 0.0});
        EXPECT_NEAR(floating.judge().share, 0.1, 1e-9) << clamp;
    }
}

/// Without gravity each block is measured by its own load, however much the other's is.
TEST(Rest, IsMeasuredByLoadsWhereThereIsNoGravity) {
    Floating floating(0.0);
    floating.push(0, {1.0, 0.0});
    floating.push(1, {1e6, 0.0});
    const Unrest unrest = floating.judge();
    EXPECT_NEAR(unrest.share, 1.0, 1e-9);
    EXPECT_EQ(unrest.restless, (std::vector<int>{0, 1}));
}

/// A seismic coefficient weighs a block as gravity does, so that a load cannot hide it.
TEST(Rest, IsMeasuredByAnAccelerationWithoutGravity) {
    Floating floating(0.0);
    floating.at.acceleration = {gravity, 0.0};
    floating.push(0, {-0.4 * pebbleWeight, 1e6 * pebbleWeight});
    floating.push(0, {0.0, -1e6 * pebbleWeight});
    floating.push(1, {-mountainWeight, 0.0});
    const Unrest unrest = floating.judge();
    EXPECT_EQ(unrest.body, 0);
    EXPECT_NEAR(unrest.share, 0.6, 1e-9);
}

/// Of gravity, the acceleration and both together the largest counts.
TEST(Rest, IsMeasuredByGravityAndAccelerationTogether) {
    Floating floating;
    floating.at.acceleration = {3.0 * gravity, -3.0 * gravity};
    floating.push(0, {-3.0 * pebbleWeight, 3.5 * pebbleWeight});
    EXPECT_NEAR(floating.judge().share, 1.0, 1e-9);
    floating.push(1, {-3.0 * mountainWeight, 4.0 * mountainWeight});
    EXPECT_NEAR(floating.judge().share, 0.1, 1e-9);
}

TEST(Rest, TakesWhatNothingActsOnAsAtRest) { EXPECT_LT(Floating(0.0).judge().beyond, 1e-12); }

}  // namespace
}  // namespace keyblock
