// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/bolt_steel.h"

#include <gtest/gtest.h>

#include <numbers>

namespace keyblock {
namespace {

BoltType bar() {
    BoltType type;
    type.diameter = 0.02;
    type.steel = {{0.0, 0.0}, {0.002, 400e6}, {0.1, 600e6}};
    return type;
}

TEST(BoltSteel, AreaIsTheFullBarUnlessGiven) {
    BoltType type = bar();
    EXPECT_DOUBLE_EQ(boltSteel(type).area, std::numbers::pi * 1e-4);
    type.area = 2e-4;
    EXPECT_DOUBLE_EQ(boltSteel(type).area, 2e-4);
}

TEST(BoltSteel, StrengthIsTheLargestStressUnlessGiven) {
    BoltType type = bar();
    type.area = 2e-4;
    EXPECT_DOUBLE_EQ(boltSteel(type).yield.value(), 80e3);
    EXPECT_DOUBLE_EQ(boltSteel(type).tensile.value(), 120e3);
    type.tensileStrength = 500e6;
    EXPECT_DOUBLE_EQ(boltSteel(type).yield.value(), 80e3);
    EXPECT_DOUBLE_EQ(boltSteel(type).tensile.value(), 100e3);
}

TEST(BoltSteel, WithoutACurveItIsUnbreakable) {
    BoltType type = bar();
    type.steel.clear();
    type.tensileStrength = 500e6;
    EXPECT_FALSE(boltSteel(type).yield);
    EXPECT_FALSE(boltSteel(type).tensile);
}

}  // namespace
}  // namespace keyblock
