// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/chains.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using Chains = std::vector<std::vector<std::size_t>>;

std::vector<Event> withCauses(const std::vector<long>& causes) {
    std::vector<Event> events(causes.size());
    for (std::size_t i = 0; i < causes.size(); ++i) events[i].cause = causes[i];
    return events;
}

TEST(Chains, FollowCausesToTheirRoot) {
    EXPECT_EQ(causeChains(withCauses({-1, 0, -1, 1, 2, 0, -1})), (Chains{{0, 1, 3, 5}, {2, 4}}));
}

TEST(Chains, LeaveOutWhatLedToNothing) {
    EXPECT_TRUE(causeChains({}).empty());
    EXPECT_TRUE(causeChains(withCauses({-1, -1, -1})).empty());
}

TEST(Chains, TakeACauseThatCannotBeForNone) {
    EXPECT_TRUE(causeChains(withCauses({0, 5, 7})).empty());
}

}  // namespace
}  // namespace keyblock
