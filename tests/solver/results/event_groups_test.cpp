// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/event_groups.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(EventGroups, ContainEveryKindOnce) {
    std::size_t kinds = 0;
    for (const EventGroupRow& group : eventGroups) {
        EXPECT_FALSE(kindsOf(group.group).empty()) << group.title;
        kinds += kindsOf(group.group).size();
    }
    EXPECT_EQ(kinds, eventKinds.size());
}

TEST(EventCounts, NameKindsAndGroupsByTheirTitles) {
    EventCounts counts;
    const auto add = [&](EventKind kind, int times) {
        Event event;
        event.kind = kind;
        for (int i = 0; i < times; ++i) counts.add(event);
    };
    EXPECT_EQ(counts.text(), "");
    add(EventKind::JointSlip, 984);
    add(EventKind::JointOpen, 208);
    add(EventKind::Debonding, 56);
    add(EventKind::Restick, 304);
    add(EventKind::Hinge, 21);
    add(EventKind::PlateLoss, 1);
    add(EventKind::BlockFalls, 2);
    EXPECT_EQ(counts.of(EventGroup::Debonding), 56);
    EXPECT_EQ(counts.of(EventGroup::Slip), 1192);
    EXPECT_EQ(counts.kindText(EventKind::Yield), "");
    EXPECT_EQ(counts.kindText(EventKind::PlateLoss), "1 plate loss");
    EXPECT_EQ(counts.kindsText(EventGroup::Slip), "984 joint slips, 208 joint openings");
    EXPECT_EQ(counts.text(), "1192 slip (984 joint slips, 208 joint openings), 56 debondings, 304 bond re-sticks, "
                             "21 plastic hinges, 1 plate loss, 2 block falls");
}

}  // namespace
}  // namespace keyblock
