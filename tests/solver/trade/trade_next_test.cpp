// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What could be left out next, from trades whose numbers are given.
#include "solver/trade/trade_next.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TradePoint pointOf(const std::string& axis, const std::string& setting, double seconds, double work, double value) {
    TradePoint point;
    point.axis = axis;
    point.setting = setting;
    point.seconds = seconds;
    point.work.fullFactorizations = static_cast<long>(work);
    point.values = {{value, "", {}}};
    return point;
}

Scene sceneOf120Divisions() {
    Scene scene;
    scene.bolts.emplace_back();
    scene.bolts.back().divisions = 120;
    return scene;
}

const std::vector<std::string> quantities{"max B.axial_force"};

TEST(TradeNext, NamesTheCheapestSettingThatChangesLittle) {
    const std::vector<TradePoint> points{
        pointOf(ownPoint, "", 10.0, 1000, 100.0), pointOf("divisions", "60", 5.5, 500, 100.4),
        pointOf("divisions", "30", 2.0, 250, 120.0), pointOf("tolerance", "0.001", 9.5, 990, 100.0)};
    const std::vector<NextLeftOut> next = measuredNext(sceneOf120Divisions(), points, quantities);
    ASSERT_EQ(next.size(), 1u);  // the tolerance saves nothing, and 30 divisions change 20 %
    EXPECT_EQ(textOf(next[0]),
              "divisions 120 → 60: 0.4 % in max B.axial_force, measured by 'trade'; saves 45 % of the time");
}

TEST(TradeNext, PutsThoseThatSaveMostFirst) {
    const std::vector<TradePoint> points{
        pointOf(ownPoint, "", 10.0, 1000, 100.0), pointOf("divisions", "60", 6.0, 500, 101.0),
        pointOf("preset", "draft", 3.0, 250, 101.0), pointOf("bond", "brittle", 1.0, 100, 100.0)};
    const std::vector<NextLeftOut> next = measuredNext(sceneOf120Divisions(), points, quantities);
    ASSERT_EQ(next.size(), 2u);  // another bolt is not another setting
    EXPECT_EQ(next[0].axis, "preset");
    EXPECT_EQ(next[1].axis, "divisions");
}

TEST(TradeNext, ReplacesCandidatesThatWereMeasured) {
    const std::vector<TradePoint> points{pointOf(ownPoint, "", 10.0, 1000, 100.0),
                                         pointOf("divisions", "60", 5.0, 500, 150.0)};
    std::vector<NextLeftOut> candidates{{"divisions", "divisions 120 → 60", "not measured", "half", "", false},
                                        {"plate", "plates as blocks → springs", "not measured", "6 unknowns", "", false}};
    const std::vector<NextLeftOut> next = withMeasured(candidates, sceneOf120Divisions(), points, quantities);
    ASSERT_EQ(next.size(), 1u);
    EXPECT_EQ(next[0].axis, "plate");
}

TEST(TradeNext, IsEmptyWithoutAResultToCompareWith) {
    std::vector<TradePoint> points{pointOf(ownPoint, "", 10.0, 1000, 100.0), pointOf("divisions", "60", 5.0, 500, 100.0)};
    EXPECT_TRUE(measuredNext({}, {}, quantities).empty());
    points[0].failure = "stage 'a' ended as failed";
    EXPECT_TRUE(measuredNext({}, points, quantities).empty());
}

}  // namespace
}  // namespace keyblock
