// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every anchor law has one row, and curves made of numbers are those of the law.
#include "solver/scene/anchor_curve.h"
#include "solver/scene/anchor_laws.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(AnchorLaws, HaveARowEachInTheOrderOfTheEnumeration) {
    for (std::size_t i = 0; i < anchorLaws.size(); ++i) EXPECT_EQ(anchorLaws[i].law, static_cast<AnchorLaw>(i)) << i;
}

TEST(AnchorLaws, HaveWordsOfTheirOwn) {
    std::set<std::string_view> keys, titles;
    for (const AnchorLawRow& row : anchorLaws) {
        keys.insert(row.key);
        titles.insert(row.title);
        EXPECT_FALSE(row.hasPoints && row.hasStrength) << row.key;  // points give the strength
        EXPECT_FALSE((row.hasResidual || row.keepsStrength) && !row.hasStrength) << row.key;
        EXPECT_FALSE(row.hasResidual && row.keepsStrength) << row.key;
    }
    EXPECT_EQ(keys.size(), anchorLaws.size());
    EXPECT_EQ(titles.size(), anchorLaws.size());
    EXPECT_FALSE(canFail(rowOf(AnchorLaw::Elastic)));
}

TEST(AnchorLaws, KeepTheirKeysInFiles) {
    constexpr std::array<std::string_view, 4> keys{"elastic", "peak-residual", "frictional", "curve"};
    for (std::size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(anchorLawWords[i], keys[i]);
}

TEST(AnchorLaws, BondThatSoftensActsAsItsCurve) {
    Anchor bond;
    bond.law = AnchorLaw::PeakResidual;
    bond.stiffness = 1e8;
    bond.strength = 2e5;
    bond.residual = 5e4;
    EXPECT_EQ(withCurve(bond), bond);  // brittle
    bond.softeningSlip = 0.006;
    const Anchor curved = withCurve(bond);
    EXPECT_EQ(curved.law, AnchorLaw::Curve);
    EXPECT_EQ(curved.curve, (Table{{0.0, 0.0}, {0.002, 2e5}, {0.002 + 0.006, 5e4}}));
    EXPECT_EQ(curved.after, AfterCurve::Last);
    EXPECT_FALSE(curved.strength.has_value());
    bond.residual = 0.0;
    EXPECT_EQ(withCurve(bond).after, AfterCurve::Zero);
    bond.law = AnchorLaw::Frictional;
    EXPECT_EQ(withCurve(bond), bond);
}

}  // namespace
}  // namespace keyblock
