// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same picture in other units and with the opposite sign: values change, colours
// stay.
#include "ui/picture/section/shown_numbers.h"

#include "tests/ui/bricks.h"
#include "ui/picture/chart.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

using namespace test;

TEST(ShownNumbers, GiveTheUnitAndTheSign) {
    const ShownAs stress = shownAs("MPa", "major principal, compression +", {true, true});
    EXPECT_EQ(stress.unit, "Pa");
    EXPECT_EQ(stress.convention, "major principal, tension +");
    EXPECT_EQ(stress.factor, -1e6);
    const ShownAs force = shownAs("kN per bolt", "tension +", {true, true});
    EXPECT_EQ(force.unit, "N per bolt");
    EXPECT_EQ(force.convention, "tension +");
    EXPECT_EQ(force.factor, 1e3);
    EXPECT_EQ(shownAs("kN", "compression +", {false, true}).factor, 1.0);  // a contact force is not a stress
    EXPECT_EQ(shownAs("kN m", "", {true, false}).unit, "N m");
    EXPECT_EQ(shownAs("kN m", "", {true, false}).factor, 1e3);
    EXPECT_EQ(withoutRoundOff(-2.9e-16, "MPa"), 0.0);
    EXPECT_EQ(withoutRoundOff(2.5e-5, "MPa"), 2.5e-5);  // 1 mm of rock
    EXPECT_EQ(withoutRoundOff(1e-8, "mm"), 1e-8);
    EXPECT_EQ(withoutRoundOff(0.5, "Pa"), 0.0);
    EXPECT_EQ(withoutRoundOff(1e-7, "kN per bolt"), 0.0);
    EXPECT_EQ(withoutRoundOff(0.5, "N"), 0.5);
    EXPECT_EQ(shownTitle("Axial force (kN) over joint opening (mm)", {true, false}),
              "Axial force (N) over joint opening (m)");
    EXPECT_EQ(shownTitle("Pins: Slip (mm), 2 (of 3", {true, true}), "Pins: Slip (m), 2 (of 3");
    EXPECT_EQ(shownTitle("Utilisation", {true, false}), "Utilisation");
    EXPECT_EQ(forceText(119e3, {}), "119 kN");
    EXPECT_EQ(forceText(119e3, {true, false}), "119\u2009000 N");
    EXPECT_EQ(lengthText(0.031, {}), "31 mm");
    EXPECT_EQ(lengthText(0.031, {true, false}), "0.031 m");
}

TEST(ShownNumbers, ReverseTheSignOfStressAndKeepColours) {
    const SectionPicture before = BricksRun().picture(1);
    SectionPicture after = before;
    showAs(after, {false, true});
    EXPECT_EQ(*after.blocks[1].value, -*before.blocks[1].value);
    for (std::size_t b = 0; b < before.blocks.size(); ++b)
        EXPECT_NEAR(after.blockLegend->shareOf(*after.blocks[b].value),
                    before.blockLegend->shareOf(*before.blocks[b].value), 1e-12);
    EXPECT_TRUE(after.blockLegend->convention.ends_with("tension +"));
    EXPECT_EQ(after.blockLegend->now->high, -before.blockLegend->now->low);
    ASSERT_GE(after.blockLegend->ticks.values.size(), 2u);
    for (const double tick : after.blockLegend->ticks.values) EXPECT_LE(tick, 0.0);
    EXPECT_LT(after.blockLegend->shareOf(after.blockLegend->ticks.values.front()),
              after.blockLegend->shareOf(after.blockLegend->ticks.values.back()));
    EXPECT_EQ(after.bolts[0].values, before.bolts[0].values);
}

TEST(ShownNumbers, ConvertTheUnitsOfEverythingDrawn) {
    const SectionPicture before = BricksRun().picture(1);
    SectionPicture after = before;
    showAs(after, {true, false});
    EXPECT_EQ(after.blockLegend->unit, "Pa");
    EXPECT_NEAR(*after.blocks[1].value, 3e6, 1e-6);
    EXPECT_EQ(after.boltLegend->unit, "N per bolt");
    EXPECT_NEAR(after.bolts[0].values[1], 1e5, 1e-6);
    ASSERT_TRUE(before.ribbon && after.ribbon);
    EXPECT_NEAR(after.ribbon->scale, 1e3 * before.ribbon->scale, 1e-6);
    EXPECT_EQ(after.boltLegend->limits.size(), before.boltLegend->limits.size());
}

TEST(ShownNumbers, ConvertTheAxesOfCharts) {
    Chart chart;
    chart.xTitle = "opening (mm)";
    chart.x = {0.0, 20.0};
    chart.events = {5.0};
    ChartPanel panel;
    panel.title = "Axial force N (kN)";
    panel.curves = {{"B", CurveStyle::Main, {0.0, 10.0}, {0.0, 150.0}}};
    panel.limits = {{"yield", 154.0, false}};
    fitRange(panel);
    const double high = panel.range.high;
    chart.panels = {panel};
    showAs(chart, {true, false});
    EXPECT_EQ(chart.xTitle, "opening (m)");
    EXPECT_NEAR(chart.x.high, 0.02, 1e-12);
    EXPECT_NEAR(chart.events[0], 0.005, 1e-12);
    EXPECT_EQ(chart.panels[0].title, "Axial force N (N)");
    EXPECT_NEAR(chart.panels[0].curves[0].x[1], 0.01, 1e-12);
    EXPECT_NEAR(chart.panels[0].curves[0].y[1], 150e3, 1e-6);
    EXPECT_NEAR(chart.panels[0].limits[0].value, 154e3, 1e-6);
    EXPECT_NEAR(chart.panels[0].range.high, 1e3 * high, 1e-6);
}

}  // namespace
}  // namespace keyblock
