// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/results/bolt_use.h"
#include "solver/results/frame_quantities.h"

#include <gtest/gtest.h>

#include <set>

namespace keyblock {
namespace {

TEST(BoltStrengths, HaveARowEachWithWordsAndAUseOfTheirOwn) {
    std::set<std::string_view> words;
    BoltExtremes extremes;
    for (std::size_t i = 0; i < boltStrengths.size(); ++i) {
        EXPECT_EQ(boltStrengths[i].strength, static_cast<BoltStrength>(i));
        words.insert(boltStrengths[i].key);
        words.insert(boltStrengths[i].title);
        (extremes.*boltStrengths[i].use).value = 0.1 * static_cast<double>(i + 1);
    }
    EXPECT_EQ(words.size(), 2 * boltStrengths.size());
    const BoltUse use = boltUse(0, extremes);
    for (std::size_t i = 0; i < boltStrengths.size(); ++i)
        EXPECT_EQ(use.use[i], 0.1 * static_cast<double>(i + 1)) << boltStrengths[i].key;
    EXPECT_EQ(use.governs, boltStrengths.back().strength);
    EXPECT_EQ(useText(use), "plate used to 40 %");
    extremes.steel.value = 0.5;
    EXPECT_EQ(useText(boltUse(0, extremes)), "steel used to 50 % of ultimate strength");
}

TEST(BoltPeaks, AreFoundByTheKeyOfTheirQuantity) {
    BoltExtremes extremes;
    for (const BoltPeakRow& row : boltPeakRows)
        EXPECT_EQ(peakOf(extremes, rowOf(row.quantity).key), &(extremes.*row.peak));
    EXPECT_EQ(peakOf(extremes, "slip"), nullptr);
}

}  // namespace
}  // namespace keyblock
