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

/// A round from x to the map of it, and what the mixing makes of that.
bool mixed(AndersonMixing& mixing, const std::vector<double>& x, std::vector<double>& next, Eigen::VectorXd& linear) {
    Eigen::VectorXd change(static_cast<Eigen::Index>(x.size()));
    for (std::size_t i = 0; i < x.size(); ++i) change[static_cast<Eigen::Index>(i)] = next[i] - x[i];
    return mixing.mix(change, next, linear);
}

bool mixed(AndersonMixing& mixing, const std::vector<double>& x, std::vector<double>& next) {
    Eigen::VectorXd none;
    return mixed(mixing, x, next, none);
}

TEST(AndersonMixing, FindsTheFixedPointOfALinearMapInFewRounds) {
    AndersonMixing mixing(4);
    std::vector<double> x{0.0, 0.0, 0.0};
    for (int round = 0; round < 5; ++round) {
        std::vector<double> next = mapped(x);
        mixed(mixing, x, next);
        x = next;
    }
    EXPECT_NEAR(x[0], 100.0, 1e-4);  // plain rounds have 4.9 by now; the normal equations keep half of the digits
    EXPECT_NEAR(x[1], 1.0 / 1.9, 1e-4);
    EXPECT_NEAR(x[2], 2.0, 1e-4);
}

TEST(AndersonMixing, CombinesWhatDependsLinearlyOnTheValuesAsItDoesThem) {
    AndersonMixing mixing(2);
    const auto sums = [](const std::vector<double>& x) { return Eigen::Vector2d(2.0 * x[0] - x[1], 3.0 + x[2]); };
    std::vector<double> x{0.0, 0.0, 0.0};
    for (int round = 0; round < 6; ++round) {
        std::vector<double> next = mapped(x);
        Eigen::VectorXd linear = sums(next);
        EXPECT_EQ(mixed(mixing, x, next, linear), round >= 2 && round % 2 == 0);
        EXPECT_LE((linear - sums(next)).norm(), 1e-12 * sums(next).norm());
        x = next;
    }
}

TEST(AndersonMixing, BeginsWithPlainRounds) {
    AndersonMixing mixing(4);
    std::vector<double> x{0.0, 0.0, 0.0};
    for (int round = 0; round < 2; ++round) {
        std::vector<double> next = mapped(x);
        EXPECT_FALSE(mixed(mixing, x, next));
        EXPECT_EQ(next, mapped(x));
        x = next;
    }
}

TEST(AndersonMixing, BeginsAgainWhereTheIterationDiverges) {
    AndersonMixing mixing(4);
    const auto round = [&](double from, double to) {
        std::vector<double> next{to};
        const bool changed = mixed(mixing, {from}, next);
        EXPECT_EQ(changed, next[0] != to);
        return changed;
    };
    EXPECT_FALSE(round(0.0, 1.0));
    EXPECT_FALSE(round(1.0, 1.5));
    EXPECT_TRUE(round(1.5, 1.75));
    EXPECT_FALSE(round(2.0, 50.0));  // the change is 48 after 0.25
    EXPECT_FALSE(round(50.0, 60.0));
    EXPECT_TRUE(round(60.0, 63.0));
}

}  // namespace
}  // namespace keyblock
