// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every kind of event has one row, with words that mean nothing else.
#include "solver/scene/event_kinds.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(EventKinds, HaveARowEachInTheOrderOfTheEnumeration) {
    for (std::size_t i = 0; i < eventKinds.size(); ++i) EXPECT_EQ(eventKinds[i].kind, static_cast<EventKind>(i)) << i;
    for (std::size_t i = 0; i < eventGroups.size(); ++i)
        EXPECT_EQ(eventGroups[i].group, static_cast<EventGroup>(i)) << i;
}

TEST(EventKinds, HaveWordsOfTheirOwn) {
    std::set<std::string_view> keys, titles;
    for (const EventKindRow& row : eventKinds) {
        keys.insert(row.key);
        titles.insert(row.title);
        titles.insert(row.plural);
        EXPECT_EQ(row.key.find(' '), std::string_view::npos) << row.key;  // requests are split at spaces
    }
    EXPECT_EQ(keys.size(), eventKinds.size());
    EXPECT_EQ(titles.size(), 2 * eventKinds.size());
}

TEST(EventKinds, KeepTheirKeysInFiles) {
    constexpr std::array<std::string_view, 13> keys{
        "joint-slip",    "joint-open", "debonding", "restick",    "yield",       "hinge",   "tensile-rupture",
        "shear-rupture", "plate-loss", "bolt-loss", "pulled-out", "block-falls", "collapse"};
    for (std::size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(eventKinds[i].key, keys[i]);
}

TEST(EventKinds, ThatAreListedSayWhatHappened) {
    for (const EventKindRow& row : eventKinds) {
        EXPECT_EQ(row.once.empty(), isMinor(row.kind)) << row.key;
        EXPECT_EQ(row.more.empty(), isMinor(row.kind)) << row.key;
    }
}

TEST(EventKinds, AreSevereWhereSupportIsLost) {
    EXPECT_TRUE(isMinor(EventKind::JointOpen) && isMinor(EventKind::Restick));
    EXPECT_FALSE(isMinor(EventKind::Debonding) || isGrave(EventKind::Debonding));
    EXPECT_FALSE(isGrave(EventKind::Hinge));
    for (const EventKind kind : {EventKind::TensileRupture, EventKind::ShearRupture, EventKind::PlateLoss,
                                 EventKind::BoltLoss, EventKind::PulledOut, EventKind::BlockFalls, EventKind::Collapse})
        EXPECT_TRUE(isGrave(kind)) << rowOf(kind).key;
}

}  // namespace
}  // namespace keyblock
