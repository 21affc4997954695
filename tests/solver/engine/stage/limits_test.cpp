// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of several limits is released: the largest overload, and of equals the
// first in the order of bolts and nodes.
#include "solver/engine/bolt/shank.h"
#include "solver/engine/contact/links.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/stage/limits.h"
#include "solver/engine/stage/step_build.h"
#include "solver/engine/time/mass.h"

#include "solver/engine/bolt/topology.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

Limit bondAt(int bolt, int node, double ratio) { return {LimitKind::Bond, bolt, node, ratio}; }

TEST(Limits, TheLargestOverloadGoesFirst) {
    const auto worst = worstLimit({bondAt(0, 1, 1.1), bondAt(0, 2, 1.3), bondAt(1, 0, 1.2)}, 1.0);
    ASSERT_TRUE(worst);
    EXPECT_EQ(worst->owner, 0);
    EXPECT_EQ(worst->part, 2);
}

TEST(Limits, ATieGoesToTheLowerBoltThenNode) {
    const double a = 1.0, b = 1.0 + 5e-7;  // equal within the share of a tie
    const auto node = worstLimit({bondAt(0, 3, a), bondAt(0, 4, b)}, 0.9);
    ASSERT_TRUE(node);
    EXPECT_EQ(node->part, 3);
    const auto bolt = worstLimit({bondAt(0, 9, a), bondAt(1, 0, b)}, 0.9);
    ASSERT_TRUE(bolt);
    EXPECT_EQ(bolt->owner, 0);
    const auto apart = worstLimit({bondAt(0, 3, 1.0), bondAt(0, 4, 1.0 + 2e-6)}, 0.9);
    ASSERT_TRUE(apart);
    EXPECT_EQ(apart->part, 4);
}

TEST(Limits, NothingUnderTheLeast) {
    EXPECT_FALSE(worstLimit({}, 0.0));
    EXPECT_FALSE(worstLimit({bondAt(0, 0, 0.99)}, 1.0));
    EXPECT_TRUE(worstLimit({bondAt(0, 0, 0.99)}, 0.99));
}

/// Two boxes bonded along their joint, the right one pressed on and pushed along it by a micrometre each.
struct BondedJoint {
    Model model;
    State state;

    BondedJoint() : model(makeModel(scene())), state(makeState(model)) {
        state.contacts = findContacts(model, state.blocks, {}, 0.01, true);
        Vector6 d = Vector6::Zero();
        d.head<2>() = Point(-1e-6, 1e-5);
        moveBlock(model.blocks[1], state.blocks[1], d);
        for (const Link& link : links()) {
            const double force = respond(link.law, link.strain).force;
            Contact& c = state.contacts[link.owner];
            (link.kind == LinkKind::Normal ? c.normalForce : c.shearForce) =
                link.kind == LinkKind::Normal ? -force : force;
        }
    }

    static Scene scene() {
        Scene scene = twoBlocks(10e9, 1.0, 2.0);
        JointMaterial& joint = scene.jointMaterials[0].second;
        joint.frictionAngle = 30.0;
        joint.cohesion = joint.tensileStrength = 1e6;
        return scene;
    }

    std::vector<Link> links() const {
        StepProblem problem;
        problem.blocks = 2;
        addContactLinks(model, state, false, problem);
        return problem.links;
    }
};

TEST(Limits, AJointThatLetsGoCarriesItsFrictionAndKeepsTheBooks) {
    BondedJoint joint;
    const double before = accountedEnergy(joint.model, joint.state);
    const double held = storedEnergy(joint.model, joint.state).contact;
    for (int i = 0; i < 2; ++i) releaseLimit(joint.model, joint.state, {LimitKind::JointBond, i, 0, 2.0});
    EXPECT_NEAR(accountedEnergy(joint.model, joint.state), before, 1e-9 * held);
    EXPECT_GT(joint.state.energy.released, 0.0);
    for (const Link& link : joint.links()) {
        if (link.kind != LinkKind::Friction) continue;
        const Contact& c = joint.state.contacts[link.owner];
        EXPECT_FALSE(c.bonded);
        EXPECT_NEAR(c.limit, c.normalForce * std::tan(std::acos(-1.0) / 6.0), 1e-9 * c.limit);
        EXPECT_NEAR(std::abs(link.law.stiffness * (link.strain - link.law.offset)), c.limit, 1e-6 * c.limit);
    }
}

/// A bar whose every strength is known, under forces at its second node and element and at its plate.
struct LoadedBolt {
    Model model;
    State state;

    explicit LoadedBolt(RuptureRule rule) : model(makeModel(scene(rule))), state(makeState(model)) {
        placeBolts(model, state);
        BoltMotion& bolt = state.bolts[0];
        bolt.nodes[1].bond.force = 10e3;
        BoltElementState& element = bolt.elements[1];
        element.strain = 1e-3;
        element.axialForce = 60e3;
        element.shearForce = 30e3;
        bolt.plateNormal = 40e3;
    }

    static Scene scene(RuptureRule rule) {
        Scene scene = twoBlocks(10e9, 1.0, 2.0);
        BoltType bar = steelType(barArea(), {{0, 0}, {0.0025, 500e6}, {0.1, 600e6}});
        bar.dynamicFactor = bar.steelDynamicFactor = bar.plateDynamicFactor = 2.0;
        bar.ruptureRule = rule;
        bar.plate.normalStrength = 100e3;
        bar.anchors = {anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e8, 20e3, 2e3)};
        addBolt(scene, bar, 0.5, 2.0, 9, PlateKind::Spring);
        return scene;
    }

    double ratio(LimitKind kind) const {
        double largest = 0.0;
        for (const Limit& limit : heldLimits(model, state))
            if (limit.kind == kind) largest = std::max(largest, limit.ratio);
        return largest;
    }
};

TEST(Limits, OfABoltAreForcesOverStrengths) {
    const LoadedBolt bolt(RuptureRule::Independent);
    EXPECT_NEAR(bolt.ratio(LimitKind::Bond), 0.5, 1e-12);
    EXPECT_NEAR(bolt.ratio(LimitKind::Yield), 0.4, 1e-12);
    EXPECT_NEAR(bolt.ratio(LimitKind::TensileRupture), 0.01, 1e-12);
    EXPECT_NEAR(bolt.ratio(LimitKind::ShearRupture), 30e3 / (0.6 * 600e6 * barArea()), 1e-12);
    EXPECT_NEAR(bolt.ratio(LimitKind::Plate), 0.4, 1e-12);
    EXPECT_EQ(bolt.ratio(LimitKind::Interaction), 0.0);
    const double tension = 60e3 / (600e6 * barArea()), shear = 30e3 / (0.6 * 600e6 * barArea());
    EXPECT_NEAR(LoadedBolt(RuptureRule::Interaction).ratio(LimitKind::Interaction), std::hypot(tension, shear), 1e-12);
}

TEST(Limits, OfABoltGrowWithTheDynamicFactor) {
    for (const RuptureRule rule : {RuptureRule::Independent, RuptureRule::Interaction}) {
        LoadedBolt bolt(rule);
        const LoadedBolt slow = bolt;
        bolt.state.bolts[0].strength = {2.0, 2.0, 2.0};
        for (const LimitKind kind : {LimitKind::Bond, LimitKind::Yield, LimitKind::ShearRupture,
                                     LimitKind::Interaction, LimitKind::Plate})
            EXPECT_NEAR(bolt.ratio(kind), 0.5 * slow.ratio(kind), 1e-12) << static_cast<int>(kind);
        EXPECT_EQ(bolt.ratio(LimitKind::TensileRupture), slow.ratio(LimitKind::TensileRupture));  // a strain
    }
}

// A hinge is judged by the moment that something held: by the elastic one under the limit of the step, and by the one
// that it leaves under the axial force of now. Where no moment was left, ends turn as they like and it says nothing.
TEST(Limits, OfAHingeAreMomentsThatWereHeld) {
    LoadedBolt loaded(RuptureRule::Independent);
    BoltMotion& motion = loaded.state.bolts[0];
    BoltElementState& element = motion.elements[1];
    const BoltModel& bolt = loaded.model.bolts[0];
    const double most = hingeForce(bolt, motion), turn = most / bendStiffness(bolt, 1);
    const auto ratioOf = [&](double bend, double limit, double axial) {
        element.bend = bend * turn;
        element.bendLimit = limit * most;
        element.axialForce = axial * 500e6 * barArea();
        return loaded.ratio(LimitKind::Hinge);
    };
    EXPECT_NEAR(ratioOf(0.5, 1.0, 0.0), 0.5, 1e-12);
    EXPECT_NEAR(ratioOf(-1.2, 1.0, 0.0), 1.2, 1e-12);
    EXPECT_NEAR(ratioOf(0.5, 1.0, 0.8), 0.5 / 0.36, 1e-12);  // 1 − 0.8² is left
    EXPECT_NEAR(ratioOf(0.5, 0.4, 0.8), 0.5 / 0.4, 1e-12);
    EXPECT_NEAR(ratioOf(5e-4, 1.0, 1.1), 0.5, 1e-12);  // of a thousandth, where nothing is left
    EXPECT_EQ(ratioOf(0.5, 0.0, 1.1), 0.0);
    motion.strength = {2.0, 2.0, 2.0};
    EXPECT_NEAR(ratioOf(0.5, 2.0, 0.0), 0.25, 1e-12);
}

TEST(Limits, ALostBoltStandsStill) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    BoltType bar = linearType(barArea(), 200e9);
    Anchor shell = anchorRange(Per::Node, AnchorLaw::PeakResidual, 1e9, 60e3, 0.0);
    shell.at = BoltPlace{false, 0.0};
    shell.onFailure = OnFailure::BoltLost;
    bar.anchors = {shell};
    addBolt(scene, bar, 0.5, 1.5, 4, PlateKind::None);
    const Model model = makeModel(scene);
    State state = makeState(model);
    for (BoltNode& node : state.bolts[0].nodes) node.velocity = {1.0, 2.0, 3.0};
    const double before = accountedEnergy(model, state);
    const std::vector<Event> events = releaseLimit(model, state, bondAt(0, 0, 1.0));
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[1].kind, EventKind::BoltLoss);
    EXPECT_TRUE(state.bolts[0].lost);
    EXPECT_EQ(kineticEnergy(model, state), 0.0);
    EXPECT_NEAR(accountedEnergy(model, state), before, 1e-12 * before);
}

}  // namespace
}  // namespace keyblock
