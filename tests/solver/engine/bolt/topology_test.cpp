// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A bolt drawn through a block, a gap, a block and out: every node knows where
// it is, and what holds it adds up to the length that is in the rock.
#include "solver/engine/bolt/bolt.h"
#include "solver/engine/bolt/slot_line.h"
#include "solver/engine/bolt/topology.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/energy.h"
#include "solver/engine/stage/step_accept.h"
#include "solver/engine/stage/step_build.h"

#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Blocks from 0 to 1 m and from 1.2 to 2.2 m; a bolt from 0.1 to 0.9 m with anchors per length.
Scene gapScene(const std::vector<Anchor>& anchors) {
    Scene scene = emptyScene(10e9, 0.2, 30.0);
    scene.blocks = {boxBlock("left", {0, 0}, {1, 1}), boxBlock("right", {1.2, 0}, {2.2, 1})};
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = anchors;
    type.normalPer = Per::Length;
    addBolt(scene, type, 0.1, 0.9, 16, PlateKind::None);
    return scene;
}

Anchor alongAll() { return anchorRange(Per::Length, AnchorLaw::Frictional, 1e9, 1e4, 0.0); }

Anchor stretch(double from, double to) {
    Anchor anchor = alongAll();
    anchor.from = {false, from};
    anchor.to = {false, to};
    return anchor;
}

struct Placed {
    Model model;
    State state;

    explicit Placed(const Scene& scene) : model(makeModel(scene)), state(makeState(model)) { placeBolts(model, state); }

    int blockOf(std::size_t node) const {
        const BoltMotion& bolt = state.bolts[0];
        return bolt.nodes[node].slot < 0 ? -1 : bolt.slots[bolt.nodes[node].slot].block;
    }

    /// Sums of the shares of the anchors and of the springs across, in one block.
    std::pair<double, double> shares(int block) const {
        std::pair<double, double> sum{0.0, 0.0};
        for (std::size_t n = 0; n < state.bolts[0].nodes.size(); ++n) {
            if (blockOf(n) != block) continue;
            if (model.bolts[0].anchors[n].real) sum.first += state.bolts[0].nodes[n].bond.share;
            sum.second += state.bolts[0].nodes[n].normalShare;
        }
        return sum;
    }

    void draw(double by) {
        for (BoltNode& node : state.bolts[0].nodes) node.x.x() += by;
        ++state.step;
        followBolts(model, state);
    }
};

double overlapOf(double a, double b, double c, double d) { return std::max(0.0, std::min(b, d) - std::max(a, c)); }

TEST(BoltTopology, SharesAddUpToTheEmbeddedLengthAllTheWay) {
    Placed bolt(gapScene({alongAll()}));
    double moved = 0.0;
    for (int i = 0; i < 260; ++i) {
        const auto [left, leftNormal] = bolt.shares(0);
        const auto [right, rightNormal] = bolt.shares(1);
        const double inLeft = overlapOf(0.1 + moved, 0.9 + moved, 0.0, 1.0);
        const double inRight = overlapOf(0.1 + moved, 0.9 + moved, 1.2, 2.2);
        EXPECT_NEAR(left, inLeft, 1e-9) << moved;
        EXPECT_NEAR(right, inRight, 1e-9) << moved;
        EXPECT_NEAR(leftNormal, inLeft, 1e-9) << moved;
        EXPECT_NEAR(rightNormal, inRight, 1e-9) << moved;
        bolt.draw(0.0097);
        moved += 0.0097;
    }
    for (const BoltNode& node : bolt.state.bolts[0].nodes) {  // right out
        EXPECT_EQ(node.slot, -1);
        EXPECT_EQ(node.bond.share, 0.0);
        EXPECT_EQ(node.normalShare, 0.0);
    }
}

TEST(BoltTopology, ANodePassesFromBlockToGapToBlockAndOut) {
    Placed bolt(gapScene({alongAll()}));
    std::vector<int> seen{bolt.blockOf(16)};
    for (int i = 0; i < 300; ++i) {
        bolt.draw(0.0049);
        if (bolt.blockOf(16) != seen.back()) seen.push_back(bolt.blockOf(16));
    }
    EXPECT_EQ(seen, (std::vector<int>{0, -1, 1, -1}));
}

TEST(BoltTopology, SharesAreClippedToTheRange) {
    const Placed bolt(gapScene({stretch(0.12, 0.53)}));
    EXPECT_NEAR(bolt.shares(0).first, 0.41, 1e-12);
    for (std::size_t n = 0; n < bolt.model.bolts[0].s.size(); ++n) {
        const double s = bolt.model.bolts[0].s[n];
        if (!bolt.model.bolts[0].anchors[n].real || (s > 0.12 - 0.025 && s < 0.53 + 0.025)) continue;
        EXPECT_EQ(bolt.state.bolts[0].nodes[n].bond.share, 0.0) << s;
    }
}

/// The length that a later entry takes over is not held twice.
TEST(BoltTopology, OverriddenLengthCountsOnce) {
    EXPECT_NEAR(Placed(gapScene({alongAll(), stretch(0.2, 0.4)})).shares(0).first, 0.8, 1e-12);
    EXPECT_NEAR(Placed(gapScene({alongAll(), stretch(0.2, 0.4), stretch(0.3, 0.6)})).shares(0).first, 0.8, 1e-12);
}

/// An element that comes out of a block of cells may pass through several of them, in either order of their rows.
TEST(BoltTopology, LengthInCellsIsTheSameEitherWay) {
    for (const auto& [from, to] : {std::pair(0.2, 1.3), std::pair(0.8, -0.3)}) {
        Scene scene = gapScene({alongAll()});
        scene.blocks[0].subBlocks = CellSettings{0.1};
        scene.bolts[0].farEnd = {from, 0.55};
        scene.bolts[0].head = {to, 0.55};
        scene.bolts[0].divisions = 4;
        scene.blocks.pop_back();
        scene.monitors.clear();
        const Placed placed(scene);
        double bonds = 0.0, across = 0.0;
        for (const BoltNode& node : placed.state.bolts[0].nodes) {
            bonds += node.bond.share;
            across += node.normalShare;
        }
        EXPECT_NEAR(bonds, 0.8, 1e-12) << from;
        EXPECT_NEAR(across, 0.8, 1e-12) << from;
    }
}

TEST(BoltTopology, ANodeOnAJointIsInNeitherBlock) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {alongAll()};
    addBolt(scene, type, 0.5, 1.5, 10, PlateKind::None);
    const Placed bolt(scene);
    EXPECT_EQ(bolt.blockOf(4), 0);
    EXPECT_EQ(bolt.blockOf(5), -1);
    EXPECT_EQ(bolt.blockOf(6), 1);
    EXPECT_NEAR(bolt.shares(0).first, 0.5, 1e-12);
    EXPECT_NEAR(bolt.shares(1).first, 0.5, 1e-12);
    EXPECT_EQ(bolt.state.bolts[0].nodes[5].bond.share, 0.0);
}

TEST(BoltTopology, ANodeFlushWithAFreeFaceIsInItsBlock) {
    Scene scene = twoBlocks(10e9, 1.0, 2.0);
    BoltType type = linearType(barArea(), 200e9);
    type.anchors = {alongAll()};
    addBolt(scene, type, 0.0, 2.0, 10, PlateKind::None);
    Placed bolt(scene);
    EXPECT_EQ(bolt.blockOf(0), 0);
    EXPECT_EQ(bolt.blockOf(10), 1);
    EXPECT_EQ(followBolts(bolt.model, bolt.state), 0.0);  // and stays there
    EXPECT_EQ(bolt.blockOf(0), 0);
    EXPECT_EQ(bolt.blockOf(10), 1);
}

TEST(BoltTopology, FollowingWithoutAMoveChangesNothing) {
    Placed bolt(gapScene({alongAll()}));
    bolt.draw(0.5);
    const std::vector<BoltNode> nodes = bolt.state.bolts[0].nodes;
    EXPECT_EQ(followBolts(bolt.model, bolt.state), 0.0);
    EXPECT_EQ(bolt.state.bolts[0].nodes, nodes);
}

TEST(BoltTopology, PerNodeSharesAreWholeOrNothing) {
    Placed bolt(gapScene({anchorRange(Per::Node, AnchorLaw::Frictional, 1e9, 1e4, 0.0)}));
    for (int i = 0; i < 30; ++i) {
        for (std::size_t n = 0; n <= 16; ++n)
            EXPECT_EQ(bolt.state.bolts[0].nodes[n].bond.share, bolt.blockOf(n) >= 0 ? 1.0 : 0.0);
        bolt.draw(0.083);
    }
}

/// Draws the bolt into the right block with all its nodes sliding in the left one under `force` per metre, until the
/// next node enters beside those that are there. \return that node.
std::size_t enterSliding(Placed& bolt, double force) {
    bolt.draw(0.33);
    const double stiffness = bolt.model.bolts[0].anchors[0].stiffness;
    for (BoltNode& node : bolt.state.bolts[0].nodes) {
        if (node.slot < 0) continue;
        const SlotLine line = slotLine(bolt.state, bolt.state.bolts[0].slots[node.slot]);
        node.bond.bonded = false;
        node.bond.curve.plastic = alongSlot(line, node) - force / stiffness;
        node.bond.offset = node.bond.curve.plastic;
        node.bond.force = -force * node.bond.share;
    }
    std::size_t next = 16;
    while (bolt.blockOf(next) == 1) --next;
    bolt.draw(0.05);
    EXPECT_EQ(bolt.blockOf(next), 1);
    return next;
}

/// Force of the law per metre where the node is now.
double lawForce(const Placed& bolt, std::size_t n) {
    const BoltNode& node = bolt.state.bolts[0].nodes[n];
    const SlotLine line = slotLine(bolt.state, bolt.state.bolts[0].slots[node.slot]);
    const AnchorModel& anchor = bolt.model.bolts[0].anchors[n];
    return anchor.stiffness * (alongSlot(line, node) - (anchor.curve ? node.bond.curve.plastic : node.bond.offset));
}

TEST(BoltTopology, ANodeThatEntersRubsLikeItsNeighbour) {
    Placed bolt(gapScene({alongAll()}));
    const std::size_t entered = enterSliding(bolt, 7e3);
    EXPECT_NEAR(lawForce(bolt, entered), 7e3, 1e-3);
    EXPECT_FALSE(bolt.state.bolts[0].nodes[entered].bond.bonded);
}

/// There is no peak to be reached twice: the bond stayed in the rock that the node left.
TEST(BoltTopology, ANodeThatEntersHasOnlyTheResidualStrength) {
    Placed bolt(gapScene({anchorRange(Per::Length, AnchorLaw::PeakResidual, 1e9, 1e4, 2e3)}));
    const std::size_t entered = enterSliding(bolt, 7e3);
    EXPECT_NEAR(lawForce(bolt, entered), 2e3, 1e-3);
    EXPECT_FALSE(bolt.state.bolts[0].nodes[entered].bond.bonded);
}

TEST(BoltTopology, AnElasticAnchorThatLeftItsBlockHoldsNothingInAnother) {
    Placed bolt(gapScene({anchorRange(Per::Length, AnchorLaw::Elastic, 1e9, std::nullopt, 0.0)}));
    EXPECT_TRUE(bolt.state.bolts[0].nodes[enterSliding(bolt, 7e3)].bond.gone);
}

TEST(BoltTopology, ACurveEndsWithItsBlock) {
    for (const AfterCurve after : {AfterCurve::Last, AfterCurve::Zero}) {
        Anchor anchor = anchorRange(Per::Length, AnchorLaw::Curve, 1e9, std::nullopt, 0.0);
        anchor.curve = {{0.0, 0.0}, {7.5e-6, 7.5e3}, {0.1, 8e3}};
        anchor.after = after;
        Placed bolt(gapScene({anchor}));
        const std::size_t entered = enterSliding(bolt, 7e3);
        const NodeBond& bond = bolt.state.bolts[0].nodes[entered].bond;
        EXPECT_EQ(bond.gone, after == AfterCurve::Zero);
        EXPECT_NEAR(lawForce(bolt, entered), 7e3, 1e-3);
        EXPECT_NEAR(yieldForce(*bolt.model.bolts[0].anchors[entered].curve, bond.curve.accumulated), 8e3, 1.0);
    }
}

/// What the embedded length stores is neither made nor lost as nodes pass.
TEST(BoltTopology, StoredEnergyThatLeavesIsReleased) {
    Placed bolt(gapScene({alongAll()}));
    enterSliding(bolt, 7e3);
    bolt.state.energy = {};
    for (int i = 0; i < 40; ++i) {
        const double before = boltEnergy(bolt.model, bolt.state, 0);
        const EnergyLedger books = bolt.state.energy;
        for (BoltNode& node : bolt.state.bolts[0].nodes) {
            node.x.x() += 0.0131;
            node.bond.offset += 0.0131;  // slides on under the same force
        }
        ++bolt.state.step;
        const double moved = boltEnergy(bolt.model, bolt.state, 0);
        EXPECT_NEAR(moved, before, 1e-12 + 1e-6 * before);
        followBolts(bolt.model, bolt.state);
        const EnergyLedger& now = bolt.state.energy;
        const double booked = now.released - books.released + now.friction - books.friction;
        EXPECT_NEAR(moved - boltEnergy(bolt.model, bolt.state, 0), booked, 1e-12);
    }
}

/// A loose end that strikes the rock beside its old hole is held there, not thrown back into the hole.
TEST(BoltTopology, ANodeThatComesInBesideItsHoleIsHeldThere) {
    Placed bolt(gapScene({alongAll()}));
    bolt.draw(0.17);  // the head is in the gap
    ASSERT_EQ(bolt.blockOf(16), -1);
    for (BoltNode& node : bolt.state.bolts[0].nodes) node.bond.bonded = false;
    BoltNode& head = bolt.state.bolts[0].nodes[16];
    head.x += Point(-0.08, 0.03);
    const double before = boltEnergy(bolt.model, bolt.state, 0);
    followBolts(bolt.model, bolt.state);
    ASSERT_EQ(bolt.blockOf(16), 0);
    EXPECT_NEAR(boltEnergy(bolt.model, bolt.state, 0), before, 1e-6 * before);
    EXPECT_NEAR(bolt.state.energy.friction, 0.0, 1e-6 * before);
}

}  // namespace
}  // namespace keyblock
