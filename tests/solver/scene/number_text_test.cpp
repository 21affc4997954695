// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lengths and areas are shown with four digits and a unit that suits their size.
#include "solver/scene/number_text.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(NumberText, LengthsHaveAUnitThatSuitsTheirSize) {
    EXPECT_EQ(lengthText(12.34567), "12.35 m");
    EXPECT_EQ(lengthText(0.04954), "49.54 mm");
    EXPECT_EQ(lengthText(2.964e-6), "2.964 µm");
    EXPECT_EQ(lengthText(-0.05), "-50 mm");
    EXPECT_EQ(lengthText(1.11e-16), "less than 1 nm");
}

TEST(NumberText, AreasHaveAUnitThatSuitsTheirSize) {
    EXPECT_EQ(areaText(727.9999999999978), "728 m²");
    EXPECT_EQ(areaText(0.003365), "33.65 cm²");
    EXPECT_EQ(areaText(7.861e-5), "78.61 mm²");
}

}  // namespace
}  // namespace keyblock
