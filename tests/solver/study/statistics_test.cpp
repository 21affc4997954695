// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
#include "solver/study/statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

TEST(SweepStatistics, WilsonsIntervalSolvesItsEquation) {
    // both ends satisfy (p − k/n)² = z² p (1 − p) / n
    constexpr double z = 1.959963984540054;
    for (const auto& [hits, trials] : {std::pair{188L, 1000L}, {1L, 10L}, {499L, 1000L}}) {
        const ChanceInterval interval = wilsonInterval(hits, trials);
        const double n = static_cast<double>(trials), share = static_cast<double>(hits) / n;
        for (const double p : {interval.low, interval.high})
            EXPECT_NEAR((p - share) * (p - share), z * z * p * (1.0 - p) / n, 1e-15);
        EXPECT_LT(interval.low, share);
        EXPECT_GT(interval.high, share);
    }
    EXPECT_EQ(wilsonInterval(0, 20).low, 0.0);
    EXPECT_NEAR(wilsonInterval(0, 20).high, z * z / (20.0 + z * z), 1e-15);
    EXPECT_EQ(wilsonInterval(20, 20).high, 1.0);
    EXPECT_EQ(wilsonInterval(0, 0).high, 1.0);
}

TEST(SweepStatistics, DeviationAndQuantilesOfASmallSample) {
    const std::vector<double> values{1.0, 2.0, 4.0, 7.0};
    const SampleStatistics s = statisticsOf(values);
    EXPECT_DOUBLE_EQ(s.mean, 3.5);
    EXPECT_DOUBLE_EQ(s.deviation, std::sqrt(21.0 / 3.0));
    EXPECT_DOUBLE_EQ(quantileOf(values, 0.5), 3.0);
    EXPECT_DOUBLE_EQ(quantileOf(values, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantileOf(values, 1.0), 7.0);
    EXPECT_EQ(statisticsOf({}).count, 0u);
}

TEST(SweepStatistics, RankCorrelationSeesOrderOnly) {
    const std::vector<double> x{1, 2, 3, 4, 5}, up{1, 8, 27, 64, 125}, down{5, 4, 3, 2, 1}, same{2, 2, 2, 2, 2};
    EXPECT_DOUBLE_EQ(rankCorrelation(x, up), 1.0);
    EXPECT_DOUBLE_EQ(rankCorrelation(x, down), -1.0);
    EXPECT_EQ(rankCorrelation(x, same), 0.0);
    // with ties: ranks 1.5, 1.5, 3 against 1, 2, 3: 1.5 / sqrt(1.5 · 2)
    EXPECT_DOUBLE_EQ(rankCorrelation(std::vector<double>{7, 7, 9}, std::vector<double>{1, 2, 3}), std::sqrt(0.75));
}

}  // namespace
}  // namespace keyblock
