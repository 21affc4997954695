// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The design table of made-up results: lengths, condition and carried blocks follow
// from the nodes and forces of the frame.
#include "solver/results/bolt_design.h"

#include "solver/results/tables.h"
#include "tests/solver/results/sample_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace keyblock {
namespace {

/// The made-up run, whose single bolt the tests change.
struct DesignCase {
    Scene scene = test::sampleScene();
    Results results = test::sampleResults();

    DesignCase() {
        for (Frame& frame : results.frames) {
            frame.bolts[0].lost = false;
            for (BoltNodeFrame& node : frame.bolts[0].nodes) {
                node.ruptured = false;
                node.real = true;
                node.state = NodeState::Bonded;
            }
        }
    }
    BoltFrame& last() { return results.frames.back().bolts[0]; }
    BoltDesign design() const {
        const MemoryRun run(scene, results);
        return boltDesigns(run, results.frames.size() - 1).at(0);
    }
};

TEST(BoltDesign, NamesTheGravestConditionOfABolt) {
    DesignCase made;
    const auto status = [&made] { return wordOf(made.design().status); };
    made.results.events.clear();
    for (Frame& frame : made.results.frames) frame.events = 0;
    EXPECT_EQ(status(), "intact");
    Event yield;
    yield.kind = EventKind::Yield;
    yield.bolt = 0;
    made.results.events = {yield};
    EXPECT_EQ(status(), "intact");  // the event is later than the frame
    made.results.frames.back().events = 1;
    EXPECT_EQ(status(), "yielded");
    made.last().nodes[1].state = NodeState::Slipping;
    EXPECT_EQ(status(), "partly-debonded");
    made.last().nodes[0].state = made.last().nodes[2].state = NodeState::Gone;
    EXPECT_EQ(status(), "debonded");
    made.last().plateHolds = false;
    EXPECT_EQ(status(), "plate-lost");
    made.scene.bolts[0].plate = PlateKind::None;
    EXPECT_EQ(status(), "debonded");
    made.results.events[0].kind = EventKind::PulledOut;
    EXPECT_EQ(status(), "pulled-out");
    made.last().nodes[0].ruptured = true;
    EXPECT_EQ(status(), "ruptured");
    made.last().lost = true;
    EXPECT_EQ(status(), "lost");
    made.last().nodes.clear();
    EXPECT_EQ(status(), "removed");
    for (Frame& frame : made.results.frames) frame.bolts[0].nodes.clear();
    EXPECT_EQ(status(), "not-installed");
}

/// Nodes at 0, 0.4 and 0.8 m own 0.2, 0.4 and 0.2 m; a node that leaves its borehole counts as debonded.
TEST(BoltDesign, CountsTheLengthThatIsNoLongerBonded) {
    DesignCase made;
    made.last().nodes[1].state = NodeState::Slipping;
    made.last().nodes[2].state = NodeState::Free;
    const BoltDesign design = made.design();
    EXPECT_DOUBLE_EQ(design.bondedLength, 0.8);
    EXPECT_DOUBLE_EQ(design.debondedLength, 0.6);
    for (Frame& frame : made.results.frames) frame.bolts[0].nodes[0].real = false;
    EXPECT_DOUBLE_EQ(made.design().bondedLength, 0.6);
}

/// A force counts with its component against the weight; that of a node in no block does not.
TEST(BoltDesign, CarriesTheBlocksThatItLifts) {
    DesignCase made;
    FrameForces& forces = made.results.frames.back().forces;
    forces.bodies = {{{0.0, -1000.0}, {}, 0.0}, {{3e3, -4e3}, {}, 0.0}};
    forces.nodes = {{500.0, 90.0}, {0.0, 1e9}, {-3e3, 4e3}};
    forces.others.clear();
    for (int n = 0; n < 3; ++n) made.last().nodes[n].block = n == 1 ? -1 : n / 2;
    const std::vector<CarriedBlock> carries = made.design().carries;
    ASSERT_EQ(carries.size(), 1U);  // 90 N is less than a tenth of 1 kN
    EXPECT_EQ(carries[0].block, 1);
    EXPECT_DOUBLE_EQ(carries[0].weight, 5e3);
    EXPECT_DOUBLE_EQ(carries[0].force, 5e3);
    forces.nodes[0].y() = 110.0;
    ASSERT_EQ(made.design().carries.size(), 2U);
    EXPECT_DOUBLE_EQ(made.design().carries[1].force, 110.0);
    forces.bodies.clear();  // a frame without forces
    EXPECT_TRUE(made.design().carries.empty());
}

/// The joint opens because of the debonding before it, so the bolt carries its block since the debonding.
TEST(BoltDesign, FollowsTheChainOfEventsToItsStart) {
    DesignCase made;
    made.results.frames.back().forces.nodes = {{0.0, 1e5}, {0.0, 0.0}, {0.0, 0.0}};
    EXPECT_EQ(made.design().since, 0);
    made.results.events[1].cause = -1;
    EXPECT_EQ(made.design().since, 1);
    made.results.events[1].kind = EventKind::JointSlip;
    EXPECT_EQ(made.design().since, 1);
    made.results.events.push_back(made.results.events[1]);
    made.results.events.back().kind = EventKind::JointOpen;
    made.results.frames.back().events = 3;
    EXPECT_EQ(made.design().since, 2);
    made.results.frames[0].bolts[0].nodes.clear();  // installed in the second stage, after these events
    made.results.frames[1].bolts[0].nodes.clear();
    EXPECT_EQ(made.design().since, -1);
}

TEST(BoltDesign, UsesTheYieldForceOfTheStage) {
    DesignCase made;
    EXPECT_FALSE(made.design().yieldForce);  // linear steel
    BoltType& type = made.scene.boltTypes[0];
    type.area = 1e-4;
    type.steel = {{0.0, 0.0}, {0.002, 400e6}, {0.1, 500e6}};
    EXPECT_DOUBLE_EQ(*made.design().yieldForce, 40e3);
    type.steelDynamicFactor = 1.25;  // the peak occurred in the dynamic stage
    EXPECT_DOUBLE_EQ(*made.design().yieldForce, 50e3);
    EXPECT_DOUBLE_EQ(*made.design().yieldUse, 1e5 * 0.09 / 50e3);
}

TEST(BoltDesign, IsATableWithARowForEachBolt) {
    const Scene scene = test::sampleScene();
    const Results results = test::sampleResults();
    const MemoryRun run(scene, results);
    const auto rows = [&run](const TableFilter& filter) {
        std::ostringstream out;
        writeTable(TableKind::Design, run, filter, out);
        const std::string text = out.str();
        return std::ranges::count(text, '\n') - 1;
    };
    EXPECT_EQ(rows({}), 1);
    TableFilter all;
    all.when = When::All;
    EXPECT_EQ(rows(all), 4);
}

}  // namespace
}  // namespace keyblock
