// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Colour maps: stops, interpolation between them, and lightness that separates low from
// high.
#include "ui/picture/colour.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE L*.
double lightness(const Colour& colour) {
    const double y = 0.2126 * linear(colour.red) + 0.7152 * linear(colour.green) + 0.0722 * linear(colour.blue);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(Colour, PassesThroughItsStops) {
    EXPECT_EQ(colourAt(slate, 0.0), rgb(0xF3EEE6));
    EXPECT_EQ(colourAt(slate, 1.0), rgb(0x264A6E));
    EXPECT_EQ(colourAt(ember, 0.5), rgb(0xC84A00));
    EXPECT_EQ(colourAt(tide, 0.5), rgb(0xF5EDE7));
    EXPECT_EQ(colourAt(slate, 0.0625), (Colour{227, 230, 221}));  // half of F3EEE6 and D2DED4
}

TEST(Colour, OutsideTheRangeIsTheEndColour) {
    EXPECT_EQ(colourAt(ember, -3.0), ember.front());
    EXPECT_EQ(colourAt(ember, 7.0), ember.back());
}

TEST(Colour, SequentialMapsDarkenByNearlyEqualSteps) {
    for (const ColourMap* map : {&slate, &ember})
        for (std::size_t i = 0; i + 1 < map->size(); ++i) {
            const double fall = lightness((*map)[i]) - lightness((*map)[i + 1]);
            EXPECT_GT(fall, 4.0);
            EXPECT_LT(fall, 11.0);
        }
}

}  // namespace
}  // namespace keyblock
