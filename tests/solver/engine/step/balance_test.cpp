// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a step in motion counts as balanced: each body by the forces on it, whatever
// its speed, its mass and what moves elsewhere.
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/step/balance.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <optional>

namespace keyblock {
namespace {

constexpr double dt = 1e-3;  // [s]

/// Two free blocks under gravity at their speeds [m/s], before the first step.
struct Flight {
    Model model;
    State state;
    Loads loads;
    LoadPoint at;
    StepProblem problem;
    Eigen::VectorXd guess;
    std::optional<LinkRows> rows;
    Trial trial;

    Flight(double density, double first, double second) : model(makeModel(scene(density))), state(makeState(model)) {
        state.blocks[0].velocity[1] = first;
        state.blocks[1].velocity[1] = second;
        at.gravity = 1.0;
        problem = buildStep(model, state, loads, at, {Inertia::Shi, dt});
        guess = Eigen::VectorXd::Zero(problem.unknowns());
        guess[1] = first * dt;
        guess[7] = second * dt;
    }

    Balance balance() {
        rows.emplace(problem);
        trial = trialAt(problem, *rows, padded(guess));
        return Balance(problem, *rows, trial, 0, 1e-4);
    }

    static Scene scene(double density) {
        Scene two = emptyScene(10e9, 0.2, 30.0);
        two.materials[0].second.density = density;
        two.analysis.gravity = {0.0, -gravity};
        two.blocks = {boxBlock("pebble", {0, 0}, {0.01, 0.01}), boxBlock("mountain", {10, 0}, {20, 10})};
        return two;
    }
};

/// The prediction leaves the weight out, and that is all of the forces there are.
TEST(Balance, KnowsNoSpeedAndNoMass) {
    for (const double density : {1e-3, 2700.0, 1e9})
        for (const double speed : {0.0, 1.0, 1e5}) {
            Flight flight(density, speed, -speed);
            const double mass = density * 100.0, least = 1e-12 * 10e9 * 10.0;  // [kg], [N]
            const double expected = mass * gravity / (mass * gravity + least);
            EXPECT_NEAR(flight.balance().residual(), expected, 1e-6 * expected + 1e-9)
                << density << ' ' << speed;
        }
}

/// The weight of a pebble is nothing beside a mountain's; left out, it is still the pebble that is not balanced.
TEST(Balance, SeesTheLightBody) {
    Flight flight(2700.0, 0.0, -100.0);
    flight.guess[7] -= 0.5 * gravity * dt * dt;  // the mountain falls as it should
    const Balance without = flight.balance();
    EXPECT_NEAR(without.residual(), 0.1, 1e-4);  // a single body may be off by ten times the tolerance
    EXPECT_EQ(without.worst(), 0);
    flight.guess[1] -= 0.5 * gravity * dt * dt;
    EXPECT_LT(flight.balance().residual(), 1e-9);
}

/// Where nothing acts, digits are all that a fast block is off by.
TEST(Balance, TakesRoundOffForBalance) {
    Flight flight(2700.0, 1e3 / 3.0, -1e4 / 7.0);
    flight.at.gravity = 0.0;
    flight.problem = buildStep(flight.model, flight.state, flight.loads, flight.at, {Inertia::Shi, dt});
    EXPECT_TRUE(flight.balance().within(1e-10));
    flight.guess[1] *= 1.0 + 1e-12;
    EXPECT_FALSE(flight.balance().within(1e-10));
}

}  // namespace
}  // namespace keyblock
