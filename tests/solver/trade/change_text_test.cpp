// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Changes and times for people: three digits, no exponents, and words for what is too
// large or too small to mean more.
#include "solver/trade/change_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace keyblock {
namespace {

TEST(ChangeText, HasThreeDigitsAndNoExponent) {
    EXPECT_EQ(threeDigits(1.593), "1.59");
    EXPECT_EQ(threeDigits(0.9996), "1");
    EXPECT_EQ(threeDigits(999.6), "1000");
    EXPECT_EQ(threeDigits(439512.0), "440000");
    EXPECT_EQ(threeDigits(-12.345), "-12.3");
    EXPECT_EQ(threeDigits(0.0012345), "0.00123");
    EXPECT_EQ(threeDigits(0.0), "0");
    EXPECT_EQ(threeDigits(1.0), "1");
    EXPECT_EQ(changeText(0.007742), "0.774 %");
    EXPECT_EQ(changeText(-9.0), "900 %");
}

TEST(ChangeText, PutsLargeChangesInTimesAndThenInWords) {
    EXPECT_EQ(changeText(43.95), "44 ×");
    EXPECT_EQ(changeText(4395.0), "more than 1000 ×");  // was 4.395e+05 %
    EXPECT_EQ(changeText(1e-9), "less than 0.001 %");
    EXPECT_EQ(changeText(0.0), "0 %");
    EXPECT_EQ(changeText(std::numeric_limits<double>::infinity()), "–");
    EXPECT_EQ(timesText(1.593), "1.59 ×");
    EXPECT_EQ(timesText(12345.0), "more than 1000 ×");
    EXPECT_EQ(signedChangeText(-0.003656), "−0.366 %");
    EXPECT_EQ(signedChangeText(1e5), "changed by more than 1000 ×");
}

/// The text is within half a unit of its third digit of every number, and has no more than three that are not zeros.
TEST(ChangeText, IsAsCloseAsThreeDigitsCanBe) {
    for (double number = 0.001; number < 1e6; number *= 1.0371) {
        const std::string text = threeDigits(number);
        EXPECT_NEAR(std::stod(text), number, 0.50001 * std::pow(10.0, std::floor(std::log10(number)) - 2.0)) << text;
        EXPECT_EQ(text.find('e'), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace keyblock
