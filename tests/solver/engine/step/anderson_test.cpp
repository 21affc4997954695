// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anderson's mixing on iterations whose fixed points are known.
#include "solver/engine/step/anderson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace keyblock {
namespace {

/// A linear map of three unknowns, each with a rate of its own; 1 / (1 − rate) is where each stays.
std::vector<double> mapped(const std::vector<double>& x) {
    return {1.0 + 0.99 * x[0], 1.0 - 0.9 * x[1], 1.0 + 0.5 * x[2]};
}

TEST(AndersonMixing, FindsTheFixedPointOfALinearMapInAsManyRoundsAsUnknowns) {
    AndersonMixing mixing(4);
    std::vector<double> x{0.0, 0.0, 0.0};
    for (int round = 0; round < 5; ++round) {
        std::vector<double> next = mapped(x);
        mixing.mix(x, next);
        x = next;
    }
    EXPECT_NEAR(x[0], 100.0, 1e-4);  // plain rounds have 4.9 by now; the normal equations keep half of the digits
    EXPECT_NEAR(x[1], 1.0 / 1.9, 1e-4);
    EXPECT_NEAR(x[2], 2.0, 1e-4);
}

TEST(AndersonMixing, BeginsWithAPlainRound) {
    AndersonMixing mixing(4);
    std::vector<double> next = mapped({0.0, 0.0, 0.0});
    EXPECT_FALSE(mixing.mix({0.0, 0.0, 0.0}, next));
    EXPECT_EQ(next, mapped({0.0, 0.0, 0.0}));
}

TEST(AndersonMixing, ForgetsWhereTheIterationGoesAstray) {
    AndersonMixing mixing(4);
    std::vector<double> next{1.0};
    EXPECT_FALSE(mixing.mix({0.0}, next));
    next = {1.5};
    EXPECT_TRUE(mixing.mix({1.0}, next));
    next = {50.0};
    EXPECT_FALSE(mixing.mix({2.0}, next));  // the change is 48 after 0.5
    EXPECT_EQ(next[0], 50.0);
}

}  // namespace
}  // namespace keyblock
