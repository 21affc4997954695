// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/scene/units.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(Units, ConvertBothWays) {
    for (const char* text : {"m", "mm", "kN/m", "kg/m³", "N/m per m", "1/s", "m⁴", "°", "MPa/m", "m/s²", "rad/s", "Nm"})
        EXPECT_TRUE(readUnit(text)) << text;
    EXPECT_EQ(readUnit("N/m per m")->powers, readUnit("Pa")->powers);
    EXPECT_FALSE(readUnit("furlong"));
    EXPECT_FALSE(readUnit("m//s"));
    EXPECT_DOUBLE_EQ(converted(1.0, *readUnit("GPa"), *readUnit("Pa")), 1e9);
    EXPECT_EQ(converted(25.0, *readUnit("mm"), *readUnit("m")), 0.025);
}

TEST(Units, FactorsOfDisplayAreTheNearestDoubles) {
    EXPECT_EQ(perSi(namedUnit("kN")), 1e-3);
    EXPECT_EQ(perSi(namedUnit("MPa")), 1e-6);
    EXPECT_EQ(perSi(namedUnit("GPa")), 1e-9);
    EXPECT_EQ(perSi(namedUnit("mm")), 1e3);
    EXPECT_EQ(perSi(*readUnit("MN/m²")), 1e-6);
    EXPECT_EQ(toSi(3.0, namedUnit("ft")), 0.9144);
    EXPECT_EQ(fromSi(2500.0, namedUnit("kN")), 2.5);
}

TEST(Units, EachSymbolIsInTheTableOnce) {
    std::set<std::string_view> seen;
    for (const UnitSymbol& symbol : unit_table::symbols) EXPECT_TRUE(seen.insert(symbol.text).second) << symbol.text;
}

TEST(Units, PracticalUnitsMeasureTheSameAsTheSiUnit) {
    for (const PracticalUnit& row : practicalUnits()) {
        const auto si = readUnit(row.si), practical = readUnit(row.practical);
        ASSERT_TRUE(si && practical) << row.si;
        EXPECT_TRUE(sameKind(*si, *practical)) << row.si;
        EXPECT_EQ(perSi(*si), 1.0) << row.si;
    }
}

}  // namespace
}  // namespace keyblock
