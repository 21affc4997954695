// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/event_groups.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(EventGroups, EveryKindHasOneAndABondThatSticksAgainDidNotLetGo) {
    std::size_t kinds = 0;
    for (std::size_t g = 0; g < eventGroups; ++g) {
        const auto group = static_cast<EventGroup>(g);
        for (const EventKind kind : kindsOf(group)) EXPECT_EQ(groupOf(kind), group);
        kinds += kindsOf(group).size();
    }
    EXPECT_EQ(kinds, eventKindWords.size());
    EXPECT_NE(groupOf(EventKind::Restick), groupOf(EventKind::Debonding));
    EXPECT_TRUE(isMinor(EventKind::JointOpen) && isMinor(EventKind::Restick));
    EXPECT_FALSE(isMinor(EventKind::Debonding) || isMinor(EventKind::Collapse));
}

TEST(EventGroups, CountsAreListedByGroupAndKind) {
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
    add(EventKind::BlockFalls, 2);
    EXPECT_EQ(counts.of(EventGroup::Debonding), 56);
    EXPECT_EQ(counts.of(EventGroup::Slip), 1192);
    EXPECT_EQ(counts.kindsText(EventGroup::Slip), "984 joint-slip, 208 joint-open");
    EXPECT_EQ(counts.text(), "1192 slip (984 joint-slip, 208 joint-open), 56 debonding, 304 restick, "
                             "21 yield (21 hinge), 2 block falls");
}

}  // namespace
}  // namespace keyblock
