// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every quantity of bolts has one row, with words that mean nothing else.
#include "solver/scene/bolt_quantities.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(BoltQuantities, HaveARowEachInTheOrderOfTheEnumeration) {
    for (std::size_t i = 0; i < boltQuantityRows.size(); ++i)
        EXPECT_EQ(boltQuantityRows[i].quantity, static_cast<BoltQuantity>(i)) << i;
}

TEST(BoltQuantities, HaveWordsOfTheirOwn) {
    std::set<std::string_view> keys, columns, titles, briefs;
    for (const BoltQuantityRow& row : boltQuantityRows) {
        keys.insert(row.key);
        columns.insert(row.column);
        titles.insert(plainTitle(row));
        briefs.insert(row.brief);
        EXPECT_TRUE(row.column.starts_with(row.key)) << row.key;
        EXPECT_EQ(row.key.find_first_of(" ."), std::string_view::npos) << row.key;  // BOLT.QUANTITY is split there
        EXPECT_GT(row.factor, 0.0) << row.key;
    }
    for (const std::set<std::string_view>& words : {keys, columns, titles, briefs})
        EXPECT_EQ(words.size(), boltQuantityRows.size());
}

TEST(BoltQuantities, KeepTheirKeysInFiles) {
    constexpr std::array<std::string_view, 10> keys{
        "axial_force", "shear_force",     "moment", "anchor_force", "slip",
        "plate_force", "debonded_length", "strain", "utilisation",  "utilisation_with_moment"};
    for (std::size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(boltQuantityWords[i], keys[i]);
}

TEST(BoltQuantities, AreNamedWithAndWithoutTheirSymbol) {
    EXPECT_EQ(rowOf(BoltQuantity::AxialForce).title, "Axial force N");
    EXPECT_EQ(plainTitle(rowOf(BoltQuantity::AxialForce)), "Axial force");
    EXPECT_EQ(titleWithUnit(rowOf(BoltQuantity::AxialForce)), "Axial force (kN)");
    EXPECT_EQ(titleWithUnit(rowOf(BoltQuantity::Slip)), "Slip (mm)");
    EXPECT_EQ(titleWithUnit(rowOf(BoltQuantity::Utilisation)), "Utilisation");
    EXPECT_EQ(plainTitle(rowOf(BoltQuantity::UtilisationWithMoment)), "Utilisation with moment");
}

}  // namespace
}  // namespace keyblock
