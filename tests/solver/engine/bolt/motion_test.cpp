// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt in a block that spins freely goes round with it: it is not drawn out,
// takes no energy and slips nowhere, however long the steps are.
#include "solver/engine/bolt/topology.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/time/mass.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {
namespace {

class NobodyLooks : public StepObserver {
public:
    void beforeEvent(const State&, double) override {}
    long event(Event, const State&, double) override { return events++; }
    void afterEvent(const State&, double) override {}

    long events = 0;
};

/// A block of 2 m × 1 m with a bar along it, held by friction that has slid before or not.
struct Spinning {
    Model model;
    State state;
    NobodyLooks events;

    explicit Spinning(bool bonded) : model(makeModel(scene())), state(makeState(model)) {
        placeBolts(model, state);
        const Point middle = state.blocks[0].centroid;
        state.blocks[0].velocity[2] = 1.0;
        for (BoltNode& node : state.bolts[0].nodes) {
            node.velocity << turnLeft(node.x - middle), 1.0;
            node.bond.bonded = node.bond.bonded && bonded;
        }
        state.startEnergy = accountedEnergy(model, state);
    }

    static Scene scene() {
        Scene scene = emptyScene(60e9, 0.2, 30.0);
        scene.blocks = {boxBlock("block", {0, 0}, {2, 1})};
        BoltType type = linearType(barArea(), 200e9);
        type.anchors = {anchorRange(Per::Length, AnchorLaw::Frictional, 1e8, 2e5, 0.0)};
        Bolt bolt;
        bolt.name = "B";
        bolt.type = type.name;
        bolt.farEnd = {0.2, 0.5};
        bolt.head = {1.8, 0.5};
        bolt.divisions = 16;
        bolt.plate = PlateKind::None;
        scene.boltTypes = {type};
        scene.bolts = {bolt};
        return scene;
    }

    /// A whole turn.
    void turn(Inertia scheme, int steps) {
        const double period = 2.0 * std::numbers::pi;
        Engine engine(model);
        const Loads none;
        DynamicSettings settings;
        settings.scheme = scheme;
        settings.timeStep = period / steps;
        DynamicStage stage(engine, none, [](double) { return LoadPoint(); }, settings);
        ASSERT_EQ(stage.begin(state).ending, Ending::Done);
        DynamicPace pace;
        for (double time = 0.0; time < period;)
            ASSERT_EQ(stage.step(state, time, period, pace, events).ending, Ending::Done);
    }

    double largestForce() const {
        double largest = 0.0;
        for (const BoltElementState& e : state.bolts[0].elements) largest = std::max(largest, std::abs(e.axialForce));
        return largest;
    }

    double largestSlip() const {
        double largest = 0.0;
        for (const BoltNode& node : state.bolts[0].nodes) largest = std::max(largest, std::abs(node.bond.offset));
        return largest;
    }
};

struct Case {
    Inertia scheme;
    bool bonded;
};

class SpinningBolt : public testing::TestWithParam<Case> {};

TEST_P(SpinningBolt, GoesRoundWithItsBlock) {
    Spinning spinning(GetParam().bonded);
    const double before = kineticEnergy(spinning.model, spinning.state);
    spinning.turn(GetParam().scheme, 250);
    // ρAω²·∫r dr over half of the bar is 0.8 N; Newmark's scheme rings
    EXPECT_LT(spinning.largestForce(), 100.0);
    EXPECT_EQ(spinning.largestSlip(), 0.0);
    EXPECT_EQ(spinning.events.events, 0);
    EXPECT_EQ(spinning.state.energy.friction, 0.0);
    EXPECT_NEAR(kineticEnergy(spinning.model, spinning.state) / before, 1.0, 1e-3);
    EXPECT_NEAR(energyOf(spinning.model, spinning.state).balanceError, 0.0, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SpinningBolt,
                         testing::Values(Case{Inertia::Shi, true}, Case{Inertia::Shi, false},
                                         Case{Inertia::Newmark, true}, Case{Inertia::Newmark, false},
                                         Case{Inertia::GeneralizedAlpha, true},
                                         Case{Inertia::GeneralizedAlpha, false}));

}  // namespace
}  // namespace keyblock
