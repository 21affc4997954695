// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The state of a bolt in one word, and how much of its bond is left.
#include "ui/picture/charts/bolt_report.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// A bolt of five nodes 0.5 m apart, one with another state.
struct OneBolt {
    OneBolt() {
        scene.bolts.emplace_back().plate = PlateKind::Spring;
        BoltFrame& bolt = frame.bolts.emplace_back();
        for (int i = 0; i < 5; ++i) {
            BoltNodeFrame& node = bolt.nodes.emplace_back();
            node.s = 0.5 * i;
            node.real = true;
            node.state = NodeState::Bonded;
        }
        bolt.plateHolds = true;
        bolt.nodes.back().axialForce = 31e3;
        frame.extremes.emplace_back().steel = {0.73, 1.0, 0, 0.2};
    }
    BoltReport report() const { return boltReport(scene, frame, 0, events); }

    Scene scene;
    Frame frame;
    std::vector<Event> events;
};

TEST(BoltReports, ABoltWithoutNodesIsNotInstalled) {
    OneBolt one;
    one.frame.bolts.front().nodes.clear();
    EXPECT_EQ(one.report().condition, BoltCondition::NotInstalled);
}

TEST(BoltReports, CountsNodesAndTheLengthWithoutBond) {
    OneBolt one;
    EXPECT_EQ(one.report().condition, BoltCondition::Intact);
    EXPECT_EQ(one.report().plateForce, 31e3);
    one.frame.bolts.front().nodes[1].state = NodeState::Slipping;
    one.frame.bolts.front().nodes[4].state = NodeState::Gone;
    const BoltReport report = one.report();
    EXPECT_EQ(report.condition, BoltCondition::PartlyDebonded);
    EXPECT_EQ(report.bonded, 3);
    EXPECT_EQ(report.slipping, 1);
    EXPECT_EQ(report.failed, 1);
    EXPECT_DOUBLE_EQ(report.debonded, 0.75);  // half of an interval belongs to the end node
    EXPECT_EQ(report.use.governs, BoltStrength::Steel);
}

TEST(BoltReports, TheMostSevereStateIsReported) {
    OneBolt one;
    const auto happens = [&](EventKind kind) {
        one.events.emplace_back().kind = kind;
        one.events.back().bolt = 0;
    };
    for (BoltNodeFrame& node : one.frame.bolts.front().nodes) node.state = NodeState::Gone;
    EXPECT_EQ(one.report().condition, BoltCondition::Debonded);
    happens(EventKind::Yield);
    EXPECT_EQ(one.report().condition, BoltCondition::Yielded);
    happens(EventKind::PlateLoss);
    one.frame.bolts.front().plateHolds = false;
    EXPECT_EQ(one.report().condition, BoltCondition::PlateLost);
    one.frame.bolts.front().nodes[2].ruptured = true;
    EXPECT_EQ(one.report().condition, BoltCondition::Ruptured);
    happens(EventKind::PulledOut);
    EXPECT_EQ(wordOf(one.report().condition), "pulled out");
}

}  // namespace
}  // namespace keyblock
