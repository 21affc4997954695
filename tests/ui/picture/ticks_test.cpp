// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round numbers and how they are written.
#include "ui/picture/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace keyblock {
namespace {

TEST(Ticks, RangesWidenToRoundNumbers) {
    EXPECT_EQ(roundedRange({0.0, 0.628}, 5), (ValueRange{0.0, 0.8}));
    EXPECT_EQ(roundedRange({0.3, 20.9}, 5), (ValueRange{0.0, 30.0}));
    EXPECT_EQ(roundedRange({-3.0, 7.0}, 5), (ValueRange{-5.0, 10.0}));
    EXPECT_EQ(roundedRange({0.0, 16.0}, 5), (ValueRange{0.0, 20.0}));
    EXPECT_EQ(roundedSymmetric({-3.0, 7.0}, 5), (ValueRange{-10.0, 10.0}));
}

TEST(Ticks, RangesWithoutWidthAreWidened) {
    EXPECT_EQ(roundedRange({0.0, 0.0}, 5), (ValueRange{0.0, 1.0}));
    EXPECT_EQ(roundedRange({5.0, 5.0}, 5), (ValueRange{0.0, 6.0}));
    EXPECT_EQ(roundedRange({-5.0, -5.0}, 5), (ValueRange{-6.0, 0.0}));
    const ValueRange tiny = roundedRange({0.0, 3e-14}, 5);
    EXPECT_GT(tiny.high, 2.9e-14);
}

TEST(Ticks, AreAtEqualRoundSteps) {
    const Ticks ticks = roundTicks({0.0, 0.6}, 5);
    ASSERT_EQ(ticks.values.size(), 4u);
    EXPECT_DOUBLE_EQ(ticks.values[1], 0.2);
    EXPECT_EQ(ticks.decimals, 1);
    EXPECT_EQ(roundTicks({0.0, 10.0}, 5).values.size(), 5u);  // 0, 2.5, …
    EXPECT_EQ(roundTicks({0.0, 10.0}, 5).decimals, 1);
    EXPECT_EQ(roundTicks({-1e9, 1e9}, 5).decimals, 0);
    const Ticks inner = roundTicks({0.13, 0.94}, 6);
    EXPECT_GE(inner.values.front(), 0.13);
    EXPECT_LE(inner.values.back(), 0.94 + 1e-12);
}

TEST(Ticks, ScaleBarsCanBeHalved) {
    EXPECT_DOUBLE_EQ(roundHalvable(1.3), 2.0);
    EXPECT_DOUBLE_EQ(roundHalvable(0.21), 0.5);
    EXPECT_DOUBLE_EQ(roundHalvable(0.2), 0.2);
    EXPECT_DOUBLE_EQ(roundHalvable(60.0), 100.0);
}

TEST(Ticks, FewOutliersAreExcludedByWeight) {
    std::vector<Weighed> values;
    for (int i = 0; i < 99; ++i) values.push_back({static_cast<double>(i), 1.0});
    values.push_back({1e6, 0.5});
    EXPECT_EQ(rangeWithout(values, 0.0), (ValueRange{0.0, 1e6}));
    EXPECT_EQ(rangeWithout(values, 0.02), (ValueRange{1.0, 97.0}));
    EXPECT_EQ(rangeWithout({}, 0.02), (ValueRange{0.0, 0.0}));
    EXPECT_EQ(rangeWithout({{3.0, 1.0}}, 0.02), (ValueRange{3.0, 3.0}));
}

/// Values of a stage that failed or of a damaged run file, and the limits of what a double holds.
std::vector<double> extremes() {
    using Limits = std::numeric_limits<double>;
    const double inf = Limits::infinity(), nan = Limits::quiet_NaN();
    return {nan,    inf, -inf, 1e308, -1e308, Limits::max(), Limits::denorm_min(), -Limits::denorm_min(),
            1e-310, 0.0, 1.0,  1e99};
}

TEST(Ticks, ExtremeRangesEnd) {
    for (const double low : extremes())
        for (const double high : extremes())
            for (const int most : {2, 5, 9}) {
                for (const ValueRange& range : {roundedRange({low, high}, most), roundedSymmetric({low, high}, most)}) {
                    EXPECT_TRUE(std::isfinite(range.low) && std::isfinite(range.high)) << low << " " << high;
                    EXPECT_LT(range.low, range.high) << low << " " << high;
                }
                const Ticks ticks = roundTicks({low, high}, most);
                EXPECT_LE(ticks.values.size(), static_cast<std::size_t>(most)) << low << " " << high;
                for (const double value : ticks.values) EXPECT_TRUE(std::isfinite(value)) << low << " " << high;
            }
}

TEST(Ticks, ExtremeStepsAreNumbersAboveZero) {
    for (const double least : extremes())
        for (const double step : {roundStep(least), roundHalvable(least)}) {
            EXPECT_TRUE(std::isfinite(step)) << least;
            EXPECT_GT(step, 0.0) << least;
        }
}

TEST(Ticks, RangesOfValuesLeaveOutWhatIsNotFinite) {
    std::vector<Weighed> values{{2.0, 1.0}, {7.0, 1.0}};
    for (const double value : extremes())
        if (!canBeShown(value)) values.push_back({value, 1.0});
    values.push_back({1.0, std::numeric_limits<double>::quiet_NaN()});
    EXPECT_EQ(rangeWithout(values, 0.0), (ValueRange{2.0, 7.0}));
    EXPECT_EQ(rangeWithout({{std::numeric_limits<double>::quiet_NaN(), 1.0}}, 0.0), (ValueRange{0.0, 0.0}));
}

TEST(NumberText, UsesATrueMinusAndThinSpaces) {
    EXPECT_EQ(numberText(-3.25, 2), "−3.25");
    EXPECT_EQ(numberText(-0.001, 1), "0.0");
    EXPECT_EQ(numberText(1234.0, 0), "1234");
    EXPECT_EQ(numberText(12345.6, 1), "12\u2009345.6");
    EXPECT_EQ(numberText(-1234567.0, 0), "−1\u2009234\u2009567");
}

TEST(NumberText, KeepsThreeSignificantDigits) {
    EXPECT_EQ(numberText(0.0), "0");
    EXPECT_EQ(numberText(0.2124), "0.212");
    EXPECT_EQ(numberText(20.94), "20.9");
    EXPECT_EQ(numberText(2.0), "2");
    EXPECT_EQ(numberText(151.4), "151");
    EXPECT_EQ(numberText(0.00126), "0.00126");
    EXPECT_EQ(numberText(3.2e-9), "3.2·10^−9");
    EXPECT_EQ(numberText(std::numeric_limits<double>::quiet_NaN()), "–");
}

}  // namespace
}  // namespace keyblock
