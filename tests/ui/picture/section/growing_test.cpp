// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Ranges that grow during a run equal those from reading all frames at once.
#include "tests/ui/bricks.h"
#include "ui/picture/charts/bolt_chart.h"
#include "ui/picture/section/section_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace keyblock {
namespace {

SectionRequest coloured() {
    SectionRequest request;
    request.blocks = findQuantity(blockQuantities(), "displacement");
    request.bolts = findQuantity(boltQuantities(), "axial_force");
    return request;
}

TEST(SectionRanges, GrowToTheRangesOfAllFrames) {
    const test::BricksRun bricks;
    const MemoryRun run(bricks.scene, bricks.results);
    const SectionRequest request = coloured();
    SectionRanges ranges(run.scene(), request);
    for (std::size_t i = 0; i < run.frames().size(); ++i) ranges.add(run.frame(i));
    const SectionLegends grown = ranges.legends(), whole = sectionLegends(run, request);
    EXPECT_EQ(grown.blocks->range, whole.blocks->range);
    EXPECT_EQ(grown.bolts->range, whole.bolts->range);
}

TEST(SectionRanges, ForgettingFramesKeepsTheLargest) {
    const Scene scene = test::bricks();
    const SectionRequest request = coloured();
    SectionRanges ranges(scene, request);
    for (int i = 0; i < 9; ++i) ranges.add(test::frameOf(scene, 0.01, i == 3 ? 90e3 : 10e3));
    const double high = ranges.legends().bolts->range.high;
    ranges.dropEverySecond();
    EXPECT_EQ(ranges.frames(), 5u);
    EXPECT_EQ(ranges.legends().bolts->range.high, high);
    EXPECT_GE(high, 90.0);
}

TEST(BoltReach, GivesTheSameChartAsAllFramesExceptEnvelopes) {
    const test::BricksRun bricks;
    const MemoryRun run(bricks.scene, bricks.results);
    BoltReach reach(0);
    for (std::size_t i = 0; i < run.frames().size(); ++i) reach.add(run.frame(i));
    const std::size_t last = run.frames().size() - 1;
    const BoltChart whole = boltChart(run, last, 0), quick = boltChart(run, last, reach);
    EXPECT_TRUE(quick.envelopes.empty());
    ASSERT_EQ(quick.chart.panels.size(), whole.chart.panels.size());
    for (std::size_t p = 0; p < quick.chart.panels.size(); ++p) {
        EXPECT_EQ(quick.chart.panels[p].title, whole.chart.panels[p].title);
        EXPECT_EQ(quick.chart.panels[p].reached, whole.chart.panels[p].reached);
        EXPECT_EQ(quick.chart.panels[p].curves.back().y, whole.chart.panels[p].curves.back().y);
    }
}

TEST(Thinned, KeepsPeaksAndOrder) {
    ChartCurve curve;
    for (int i = 0; i < 10000; ++i) {
        curve.x.push_back(i);
        curve.y.push_back(i == 4321 ? 100.0 : i == 777 ? -50.0 : 0.001 * (i % 7));
    }
    const ChartCurve few = thinned(curve, 400);
    EXPECT_LE(few.y.size(), 400u);
    EXPECT_EQ(*std::max_element(few.y.begin(), few.y.end()), 100.0);
    EXPECT_EQ(*std::min_element(few.y.begin(), few.y.end()), -50.0);
    EXPECT_TRUE(std::is_sorted(few.x.begin(), few.x.end()));
    EXPECT_EQ(few.x.front(), 0.0);
    EXPECT_EQ(few.x.back(), 9999.0);
    EXPECT_EQ(thinned(few, 500).y, few.y);
}

}  // namespace
}  // namespace keyblock
