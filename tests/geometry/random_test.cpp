// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A seed means the same numbers for ever, streams have nothing to do with each
// other, and the distributions are what their names say.
#include "geometry/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

struct Sample {
    double mean = 0.0, deviation = 0.0, least = 0.0, most = 0.0;
};

Sample sampleOf(int count, const std::function<double()>& draw) {
    std::vector<double> values(count);
    std::generate(values.begin(), values.end(), draw);
    Sample s{0.0, 0.0, values.front(), values.front()};
    for (const double v : values) {
        s.mean += v / count;
        s.least = std::min(s.least, v);
        s.most = std::max(s.most, v);
    }
    double square = 0.0;
    for (const double v : values) square += (v - s.mean) * (v - s.mean) / count;
    s.deviation = std::sqrt(square);
    return s;
}

// The values come from the same rules written in another language.
TEST(Random, GivesTheSameNumbersForEver) {
    EXPECT_EQ(Random(7).bits(), 0xb8b4c2977eabce45u);
    Random bits(7, {-3, 2});
    EXPECT_EQ(bits.bits(), 0xab1853f80f67fc5du);
    EXPECT_EQ(bits.bits(), 0xb2286435a0a0ca8bu);
    Random uniform(7, {-3, 2});
    for (const double expected : {0.6683399658790278, 0.695928824513092, 0.1741643760059023})
        EXPECT_EQ(uniform.uniform(), expected);
    Random normal(7, {-3, 2});
    for (const double expected : {1.0592087080705228, 1.565206121972563, 0.06537165481710541, 0.2511286627446524})
        EXPECT_NEAR(normal.normal(), expected, 1e-12);
}

TEST(Random, StreamsOfOtherNamesDiffer) {
    EXPECT_NE(Random(1).bits(), Random(2).bits());
    EXPECT_NE(Random(1, {0}).bits(), Random(1).bits());
    EXPECT_NE(Random(1, {0, 1}).bits(), Random(1, {1, 0}).bits());
    EXPECT_NE(Random(1, {5}).bits(), Random(1, {-5}).bits());
}

TEST(Random, NeighbouringStreamsAreUncorrelated) {
    constexpr int count = 100000;
    double sum = 0.0;
    for (int i = 0; i < count; ++i)
        sum += (Random(3, {i}).uniform() - 0.5) * (Random(3, {i + 1}).uniform() - 0.5);
    // Each term has the variance 1/144, so the sum of n has the deviation √n/12; four of them.
    EXPECT_LT(std::abs(sum), 4.0 * std::sqrt(count) / 12.0);
}

TEST(Random, UniformIsEvenOverItsRange) {
    constexpr int count = 200000;
    Random random(11);
    const Sample s = sampleOf(count, [&] { return random.uniform(); });
    const double deviation = std::sqrt(1.0 / 12.0);
    EXPECT_NEAR(s.mean, 0.5, 4.0 * deviation / std::sqrt(count));
    EXPECT_NEAR(s.deviation, deviation, 0.002);
    EXPECT_GE(s.least, 0.0);
    EXPECT_LT(s.most, 1.0);
}

TEST(Random, NormalHasItsShares) {
    constexpr int count = 200000;
    Random random(12);
    int withinOne = 0, withinTwo = 0;
    const Sample s = sampleOf(count, [&] {
        const double z = random.normal();
        withinOne += std::abs(z) < 1.0;
        withinTwo += std::abs(z) < 2.0;
        return z;
    });
    const double step = 1.0 / std::sqrt(count);
    EXPECT_NEAR(s.mean, 0.0, 4.0 * step);
    EXPECT_NEAR(s.deviation, 1.0, 4.0 * step);
    EXPECT_NEAR(static_cast<double>(withinOne) / count, std::erf(std::sqrt(0.5)), 2.0 * step);
    EXPECT_NEAR(static_cast<double>(withinTwo) / count, std::erf(std::sqrt(2.0)), 2.0 * step);
}

TEST(Random, ACutNormalStaysWithinTheCut) {
    Random random(13);
    const Sample s = sampleOf(100000, [&] { return random.normalWithin(1.5); });
    EXPECT_GE(s.least, -1.5);
    EXPECT_LE(s.most, 1.5);
    // Variance of the normal distribution cut at ±c: 1 − 2cφ(c)/(2Φ(c) − 1).
    const double density = std::exp(-0.5 * 1.5 * 1.5) / std::sqrt(2.0 * std::acos(-1.0));
    EXPECT_NEAR(s.deviation, std::sqrt(1.0 - 3.0 * density / std::erf(1.5 / std::sqrt(2.0))), 0.005);
}

TEST(Scatter, KeepsItsMeanInSpiteOfTheCut) {
    constexpr int count = 200000;
    // Shares of the deviation that the cut leaves, from the moments of the cut distribution.
    const std::vector<std::pair<double, double>> kept{{0.1, 0.98603}, {0.5, 0.97268}, {1.0, 0.93244}};
    for (const auto& [ratio, share] : kept) {
        const Scatter scatter{2.0, 2.0 * ratio};
        Random random(14);
        const Sample s = sampleOf(count, [&] { return draw(random, scatter); });
        EXPECT_NEAR(s.mean, 2.0, 4.0 * scatter.deviation / std::sqrt(count)) << ratio;
        EXPECT_NEAR(s.deviation / scatter.deviation, share, 0.02) << ratio;
        EXPECT_GT(s.least, 0.0);
        EXPECT_LE(s.most, largest(scatter));
    }
}

TEST(Scatter, WithoutDeviationIsItsMean) {
    Random random(15);
    EXPECT_EQ(draw(random, {1.2, 0.0}), 1.2);
    EXPECT_EQ(largest({1.2, 0.0}), 1.2);
    EXPECT_EQ(random.bits(), Random(15).bits()) << "nothing was drawn";
    EXPECT_EQ(largest({0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace keyblock
