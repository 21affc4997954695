// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The dots of a trade chart stand out against paper and against the panels of both themes.
#include "ui/figure/trade_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Relative luminance of an sRGB colour, as in the Web Content Accessibility Guidelines 2.1.
double luminance(const Colour& colour) {
    const auto linear = [](std::uint8_t value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
}

double contrast(const Colour& a, const Colour& b) {
    const double low = std::min(luminance(a), luminance(b)), high = std::max(luminance(a), luminance(b));
    return (high + 0.05) / (low + 0.05);
}

TEST(TradeColours, StandOutAgainstLightAndDarkGround) {
    const Colour paper = rgb(0xFFFFFF), dark = rgb(0x1B1F26);
    for (std::size_t number = 0; number < 10; ++number) {
        EXPECT_GT(contrast(tradeColour(number, paper), paper), 2.0) << number;
        EXPECT_GT(contrast(tradeColour(number, dark), dark), 4.5) << number;
        for (std::size_t other = 0; other < number; ++other)
            EXPECT_FALSE(tradeColour(number, dark) == tradeColour(other, dark)) << number << " and " << other;
    }
}

}  // namespace
}  // namespace keyblock
