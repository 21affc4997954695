// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of several limits is released: the largest overload, and of equals the
// first in the order of bolts and nodes.
#include "solver/engine/limits.h"

#include "solver/engine/contacts.h"
#include "solver/engine/step_build.h"
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
            Contact& c = state.contacts[static_cast<std::size_t>(link.owner)];
            (link.kind == LinkKind::Normal ? c.normalForce : c.shearForce) =
                link.kind == LinkKind::Normal ? -force : force;
        }
    }

    static Scene scene() {
        Scene scene = twoBlocks(10e9, 1.0, 2.0);
        scene.jointMaterials[0].second = {30.0, 1e6, 1e6};
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
    const double before = bookedEnergy(joint.model, joint.state);
    const double held = storedEnergy(joint.model, joint.state).contact;
    for (int i = 0; i < 2; ++i) releaseLimit(joint.model, joint.state, {LimitKind::JointBond, i, 0, 2.0});
    EXPECT_NEAR(bookedEnergy(joint.model, joint.state), before, 1e-9 * held);
    EXPECT_GT(joint.state.energy.released, 0.0);
    for (const Link& link : joint.links()) {
        if (link.kind != LinkKind::Friction) continue;
        const Contact& c = joint.state.contacts[static_cast<std::size_t>(link.owner)];
        EXPECT_FALSE(c.bonded);
        EXPECT_NEAR(c.limit, c.normalForce * std::tan(std::acos(-1.0) / 6.0), 1e-9 * c.limit);
        EXPECT_NEAR(std::abs(link.law.stiffness * (link.strain - link.law.offset)), c.limit, 1e-6 * c.limit);
    }
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
    const double before = bookedEnergy(model, state);
    const std::vector<Event> events = releaseLimit(model, state, bondAt(0, 0, 1.0));
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[1].kind, EventKind::BoltLoss);
    EXPECT_TRUE(state.bolts[0].lost);
    EXPECT_EQ(kineticEnergy(model, state), 0.0);
    EXPECT_NEAR(bookedEnergy(model, state), before, 1e-12 * before);
}

}  // namespace
}  // namespace keyblock
