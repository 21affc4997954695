// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The books of energy, term by term: closed forms of single terms, the balance
// of static increments however long they are, and the balance as a check that
// sees a term that is wrong.
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/dynamics.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/stage/step_build.h"
#include "solver/run/run.h"
#include "solver/verify/scenes.h"
#include "tests/solver/run/small_stages.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using test::weight;

Scene settlingBox(double frictionAngle, double modulus) {
    Scene scene = emptyScene(modulus, 0.2, frictionAngle);
    scene.blocks = {boxBlock("base", {-1, -1}, {9, 0}), boxBlock("box", {0, 0}, {1, 1})};
    Support support;
    support.blockAt = Point(4.0, -0.5);
    scene.supports = {support};
    scene.analysis.gravity = {0.0, -gravity};
    Stage stage;
    stage.name = "settle";
    scene.stages = {stage};
    return scene;
}

Results ran(const Scene& scene, double error = 1e-3) {
    Results results = runInMemory(scene);
    for (const StageResult& stage : results.stages) {
        EXPECT_EQ(stage.outcome, Outcome::Equilibrium) << stage.message;
        EXPECT_LT(std::abs(stage.health.balanceError), error) << "stage " << stage.stage;
    }
    return results;
}

/// The weight at once squeezes a soft block, whose foot slides outwards on the way.
TEST(Energies, GravityAtOnceWithSlidingCorners) {
    for (const double frictionAngle : {0.0, 2.0, 5.0, 30.0}) {
        const Results results = ran(settlingBox(frictionAngle, 1e7));
        const Energy& energy = results.frames.back().energy;
        EXPECT_GT(energy.external, 0.0);
        if (frictionAngle == 2.0) {
            EXPECT_GT(energy.friction, 1e-3 * energy.external);
        }
        EXPECT_GE(energy.damped, -1e-9 * energy.external);
    }
}

/// A block that drops in a static stage has lost its way's work to what is damped.
TEST(Energies, AStaticDropIsDamped) {
    Scene scene = settlingBox(30.0, 10e9);
    for (Point& p : scene.blocks[1].points) p.y() += 0.02;
    const Energy energy = ran(scene).frames.back().energy;
    EXPECT_NEAR(energy.damped, 0.5 * weight * 0.02, 1e-3 * weight * 0.02);
    EXPECT_NEAR(energy.external, 0.5 * weight * 0.02, 1e-3 * weight * 0.02);
}

/// Dragged over its base: friction is the weight's share times the way, and the drive pays it.
TEST(Energies, DraggedFrictionIsItsForceTimesTheWay) {
    for (const int increments : {1, 5, 50}) {
        Scene scene = settlingBox(20.0, 10e9);
        Stage drag;
        drag.name = "drag";
        drag.increments = increments;
        Motion motion;
        motion.blockAt = {0.5, 0.4};
        motion.table = {{0.0, 0.0}, {1.0, 0.3}};
        drag.motions = {motion};
        scene.stages.push_back(drag);
        const Energy energy = ran(scene).frames.back().energy;
        const double expected = weight * std::tan(20.0 * degree) * 0.3;
        EXPECT_NEAR(energy.friction, expected, 1e-3 * expected) << increments;
        EXPECT_NEAR(energy.external, expected, 1e-3 * expected) << increments;
    }
}

/// A bar whose bond slips to and fro, in long and in short increments.
TEST(Energies, BondFrictionToAndFro) {
    for (const int increments : {8, 40, 160}) {
        Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
        BoltType type = linearType(barArea(), 200e9);
        type.anchors = {anchorRange(Per::Node, AnchorLaw::PeakResidual, 84.78e6, 24.56e3, 2.24e3)};
        addBolt(scene, type, 0.05, 1.95, 19, PlateKind::None);
        scene.stages = {pullStage(scene, 6e-3, increments)};
        scene.stages[0].motions[0].table = {{0.0, 0.0}, {0.5, 6e-3}, {1.0, 0.0}};
        ran(scene);
    }
}

/// A bar with two yield points pulled far in one increment or in many: the same work.
TEST(Energies, PlasticWorkDoesNotDependOnTheIncrements) {
    double external[2], plastic[2];
    for (const int which : {0, 1}) {
        BoltType bar = steelType(barArea(), {{0.0, 0.0}, {0.002, 400e6}, {0.02, 440e6}, {0.2, 450e6}});
        bar.anchors = {anchorAt(0.0, AnchorLaw::Elastic, 1e9), anchorAt(2.0, AnchorLaw::Elastic, 1e9)};
        Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
        addBolt(scene, bar, 0.0, 2.0, 20, PlateKind::None);
        scene.stages = {pullStage(scene, 0.06, which == 0 ? 2 : 100)};
        const Energy energy = ran(scene).frames.back().energy;
        external[which] = energy.external;
        plastic[which] = energy.plastic;
    }
    EXPECT_NEAR(external[0], external[1], 2e-3 * external[1]);
    EXPECT_NEAR(plastic[0], plastic[1], 2e-3 * plastic[1]);
}

/// Pulled askew, a block slides along the face that it leaves, and meets it in other contacts than at first: what these
/// were found with is no force that they had before.
TEST(Energies, ContactsThatAreFoundOnTheWayBringNothing) {
    for (const double opening : {5e-5, 6e-4}) {
        Scene scene = twoBlocks(60e9, 1.0, 2.0);
        BoltType bar = linearType(barArea(), 200e9);
        bar.anchors = {anchorRange(Per::Node, AnchorLaw::Elastic, 84.78e6, std::nullopt, 0.0)};
        addBolt(scene, bar, 0.05, 1.95, 19, PlateKind::None);
        scene.stages = {pullStage(scene, opening, 1)};
        scene.stages[0].motions[0].axis = {std::cos(40.0 * degree), std::sin(40.0 * degree)};
        const Energy energy = ran(scene, 1e-2).frames.back().energy;
        EXPECT_LT(energy.damped, 1e-2 * energy.external);
    }
}

/// A tube that is drawn out of its hole gives back what the springs of the lost length held.
TEST(Energies, ALengthThatLeavesTheRockIsReleased) {
    Scene scene = twoBlocks(60e9, 0.3, 1.0);
    BoltType tube = linearType(380e-6, 200e9);
    tube.anchors = {anchorRange(Per::Length, AnchorLaw::Frictional, 5e8, 200e3, 0.0)};
    addBolt(scene, tube, 0.0, 1.0, 40, PlateKind::Spring);
    scene.stages = {pullStage(scene, 0.2, 60)};
    const Energy energy = ran(scene).frames.back().energy;
    EXPECT_GT(energy.released, 0.0);
}

/// What slides away in a static stage has turned its weight's work into friction and into what is damped.
TEST(Energies, ACollapseKeepsTheBooks) {
    Scene scene = settlingBox(20.0, 10e9);
    scene.analysis.gravity = {gravity * std::sin(40.0 * degree), -gravity * std::cos(40.0 * degree)};
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[0].outcome, Outcome::Collapse);
    EXPECT_LT(std::abs(results.stages[0].health.balanceError), 1e-3);
    const Energy& energy = results.frames.back().energy;
    EXPECT_GT(energy.friction, 0.0);
    EXPECT_GT(energy.damped, 0.0);
}

/// A block pushed off the end of a smooth floor falls past its side: the corners that meet the side stood behind its line
/// all the way, and those that stood on the top are there no more. All that is left is what the loads did, damped.
TEST(Energies, AFallOffAnEdgeKeepsTheBooks) {
    Scene scene = settlingBox(0.0, 10e9);
    scene.blocks[1] = boxBlock("box", {-1.65, 0}, {-0.15, 0.4});
    scene.analysis.tolerance = 1e-4;
    Stage push;
    push.name = "push";
    Load load;
    load.blockAt = Point(-0.5, 0.1);
    load.force = {-500.0, 0.0};
    load.table = {{0.0, 0.0}, {1.0, 1.0}};
    push.loads = {load};
    scene.stages.push_back(push);
    const Results results = runInMemory(scene);
    ASSERT_EQ(results.stages[1].outcome, Outcome::Collapse);
    EXPECT_LT(std::abs(results.stages[1].health.balanceError), 1e-3);
    const Frame& last = results.frames.back();
    const double fall = -weight * 0.6 * last.blocks[1].displacement.y();
    const double slide = 500.0 * std::abs(last.blocks[1].displacement.x());
    EXPECT_GT(fall, 1e3);
    EXPECT_GT(last.energy.external, fall);
    EXPECT_LT(last.energy.external, fall + slide);
    EXPECT_NEAR(last.energy.damped, last.energy.external, 1e-3 * last.energy.external);
}

/// A weight in motion on a bar that yields, slips and lets go: every term is there.
struct Everything {
    Scene scene = emptyScene(rigidRock, 0.2, 0.0);
    Model model;
    State state;

    Everything() : model(makeModel(hang())), state(makeState(model)) {
        placeBolts(model, state);
        Engine engine(model);
        const Loads loads;
        LoadPoint at;
        at.gravity = 1.0;
        struct Deaf : StepObserver {
            void beforeEvent(const State&, double) override {}
            long event(Event, const State&, double) override { return 0; }
            void afterEvent(const State&, double) override {}
        } observer;
        DynamicStage stage(engine, loads, [&](double) { return at; }, {Inertia::Shi, 1e-4});
        DynamicPace pace;
        EXPECT_EQ(stage.begin(state).ending, Ending::Done);
        double time = 0.0;
        for (int i = 0; i < 2000 && time < 0.08; ++i)
            EXPECT_EQ(stage.step(state, time, 0.08, pace, observer).ending, Ending::Done);
    }

    const Scene& hang() {
        scene.blocks = {boxBlock("left", {0, 0}, {1, 1}), boxBlock("right", {1.1, 0}, {2.1, 1})};
        Support support;
        support.blockAt = Point(0.5, 0.1);
        scene.supports = {support};
        scene.analysis.gravity = {gravity, 0.0};
        BoltType bar = steelType(1e-4, {{0.0, 0.0}, {0.0015, 300e6}, {0.1, 500e6}});
        bar.bending = Bending::None;
        Anchor weak = anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e8, 30.5e3, 15e3);
        weak.at = BoltPlace{false, 0.0};
        bar.anchors = {weak, anchorAt(1.5, AnchorLaw::Elastic, 1e9)};
        addBolt(scene, bar, 0.3, 1.8, 15, PlateKind::None);
        return scene;
    }

    double error() const { return std::abs(energyOf(model, state).balanceError); }
};

TEST(Energies, TheBalanceSeesEveryTerm) {
    Everything run;
    EXPECT_LT(run.error(), 1e-3);
    const Energy energy = energyOf(run.model, run.state);
    for (double EnergyLedger::* term : {&EnergyLedger::friction, &EnergyLedger::plastic, &EnergyLedger::released,
                                        &EnergyLedger::damped, &EnergyLedger::external}) {
        State wrong = run.state;
        const double value = wrong.energy.*term;
        EXPECT_GT(value, 2e-3 * energy.external);
        wrong.energy.*term = 0.0;
        EXPECT_GT(std::abs(energyOf(run.model, wrong).balanceError), 0.9 * value / energy.external - 1e-3);
    }
    State slower = run.state;
    slower.blocks[1].velocity *= 0.9;
    EXPECT_GT(std::abs(energyOf(run.model, slower).balanceError), 0.15 * energy.kinetic / energy.external);
    State slack = run.state;
    slack.bolts[0].nodes[0].x.x() += 1e-3;
    EXPECT_GT(std::abs(energyOf(run.model, slack).balanceError), 1e-3);
}

}  // namespace
}  // namespace keyblock
